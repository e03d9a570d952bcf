// A script link to a simulated controller, with the ledger of what it reads: bytes go from one to the other
// as they come.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/link/script_link.h"
#include "cobot_command/robot/read_ledger.h"

namespace cobot_command::testing {

class LinkedRobot : private link::Wire {
 public:
  explicit LinkedRobot(simulator::Settings project) : robot(std::move(project)) {
    link.start("robot", 5890, robot.now());
    client_ = robot.connect();
    link.opened(robot.now());
    carry();
  }

  /// Sends the script that reads; the outcome comes when the controller has got to it.
  void ask(std::vector<script::AttributeRead> reads) {
    script::ReadingScript script{"us " + std::to_string(++marks_), std::move(reads)};
    const std::string id = link.sendScript(toText(script), robot.now());
    ledger.sent(std::move(script), id, robot.now() + std::chrono::seconds(1));
    carry();
  }
  std::optional<robot::ReadOutcome> read(std::vector<script::AttributeRead> reads) {
    ask(std::move(reads));
    return takeOutcome();
  }
  /// Any script, and whether the controller has done it.
  bool run(const std::string& script) {
    const std::string id = link.sendScript(script, robot.now());
    carry();
    return accepted_ == id;
  }
  std::optional<robot::ReadOutcome> takeOutcome() { return std::exchange(outcome_, std::nullopt); }
  /// What was for somebody else.
  [[nodiscard]] const std::vector<protocol::ListenData>& others() const { return others_; }

  void operate(const simulator::OperatorAction& action) {
    const auto reply = robot.operate(action);
    EXPECT_TRUE(reply.done) << reply.text;
    carry();
  }
  void wait(Duration duration) {
    robot.wait(duration);
    carry();
    tell(ledger.advance(robot.now()));
  }

  simulator::test::SimulatedRobot robot;
  const link::LinkSettings settings = link::LinkSettings();
  link::ScriptLink link{settings, *this};
  robot::ReadLedger ledger;

 private:
  link::ConnectionId open(link::Channel /*channel*/, const std::string& /*host*/, int /*port*/,
                          Duration /*timeout*/) override {
    return 1;
  }
  void close(link::ConnectionId /*id*/) override {}
  void send(link::ConnectionId /*id*/, std::string bytes) override { robot.send(client_, bytes); }
  [[nodiscard]] bool isTraced(link::Channel /*channel*/) const override { return false; }
  void trace(Instant /*now*/, link::Channel /*channel*/, bool /*sent*/, std::string_view /*bytes*/,
             std::string /*meaning*/) override {}

  void carry() {
    for (std::string bytes = robot.heard(client_); !bytes.empty(); bytes = robot.heard(client_)) {
      link.received(bytes);
    }
    const std::string dropped = "x" + std::to_string(client_);
    for (const std::string& event : robot.events()) {
      if (event == dropped) link.closed("closed by the controller", robot.now());
    }
    while (const auto output = link.next(robot.now())) {
      std::visit([this](const auto& what) { take(what); }, *output);
    }
  }
  void take(const link::ScriptAnswered& answered) {
    const auto* reply = std::get_if<protocol::ScriptReply>(&answered.answer);
    if (reply != nullptr && reply->accepted) accepted_ = answered.id;
    tell(ledger.take(answered));
  }
  void take(const protocol::ListenData& data) {
    if (!ledger.take(data)) others_.push_back(data);
  }
  void take(const link::LinkLost& lost) { tell(ledger.lost(lost.reason)); }
  template <class Other>
  void take(const Other& /*output*/) {}
  void tell(std::optional<robot::ReadOutcome> outcome) {
    if (outcome) outcome_ = std::move(outcome);
  }

  simulator::ClientId client_ = 0;
  int marks_ = 0;
  std::string accepted_;
  std::optional<robot::ReadOutcome> outcome_;
  std::vector<protocol::ListenData> others_;
};

}  // namespace cobot_command::testing
