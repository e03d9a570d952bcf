// What the controller has to say, in order, until its owner takes it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::simulator {

class Outbox {
 public:
  /// The time that the log lines carry from now on.
  void setTime(Instant now) { now_ = now; }
  [[nodiscard]] Instant now() const { return now_; }

  void send(Port port, ClientId client, std::string bytes) {
    outputs_.emplace_back(Send{port, client, std::move(bytes)});
  }
  void closeClient(Port port, ClientId client) { outputs_.emplace_back(CloseClient{port, client}); }
  void openPort(Port port) { outputs_.emplace_back(OpenPort{port}); }
  void closePort(Port port) { outputs_.emplace_back(ClosePort{port}); }
  /// Whatever clients, operator and settings have put into it.
  void log(std::string text) { outputs_.emplace_back(LogLine{now_, forPeople(std::move(text))}); }

  [[nodiscard]] std::vector<Output> take() { return std::exchange(outputs_, {}); }

 private:
  Instant now_{};
  std::vector<Output> outputs_;
};

}  // namespace cobot_command::simulator
