// A simulated controller with invented time and clients that are nothing but bytes.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/protocol/frame.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::simulator::test {

using namespace std::chrono_literals;

class SimulatedRobot {
 public:
  explicit SimulatedRobot(Settings settings = {}, const std::string& model = "tm5-700")
      : controller_(arm::ArmModel::named(model).value(), std::move(settings), Instant{}) {
    collect();
  }

  /// Connects a client, and forgets what was said before.
  ClientId connect(Port port = Port::Script) {
    const ClientId client = ++clients_;
    controller_.clientConnected(port, client, now_);
    collect();
    return client;
  }
  void disconnect(ClientId client, Port port = Port::Script) {
    controller_.clientDisconnected(port, client, now_);
    collect();
  }

  void send(ClientId client, const std::string& bytes, Port port = Port::Script) {
    controller_.received(port, client, bytes, now_);
    collect();
  }
  void script(ClientId client, const std::string& id, const std::string& script) {
    send(client, protocol::encodeFrame("TMSCT", id + "," + script));
  }
  /// Sends a TMSTA and gives the data of the answer.
  std::string ask(ClientId client, const std::string& data) {
    heard(client);
    send(client, protocol::encodeFrame("TMSTA", data));
    return heard(client);
  }

  /// Lets time go by.
  void wait(Duration duration) { waitUntil(now_ + duration); }
  void waitUntil(Instant instant) {
    now_ = instant;
    controller_.advance(now_);
    collect();
  }
  /// From event to event until nothing moves and nothing is queued. Only without status clients.
  void waitUntilIdle() {
    while (controller_.nextEvent() != Instant::max()) waitUntil(controller_.nextEvent());
  }

  OperatorReply operate(const OperatorAction& action) {
    OperatorReply reply = controller_.operate(action, now_);
    collect();
    return reply;
  }
  void runProject() { operate(RunProject{}); }
  void stopProject() { operate(StopProject{}); }
  void setEmergencyStop(bool pressed) { operate(SetEmergencyStop{pressed}); }

  /// All bytes that a client got since the last call.
  std::string heard(ClientId client) { return std::exchange(heard_[client], {}); }
  /// Ports that opened (+) and closed (-), clients that were dropped (x), in order: "+script", "x1",
  /// "-script".
  std::vector<std::string> events() { return std::exchange(events_, {}); }
  [[nodiscard]] const std::vector<LogLine>& log() const { return log_; }

  [[nodiscard]] Instant now() const { return now_; }
  [[nodiscard]] RobotState state() const { return controller_.state(); }
  [[nodiscard]] arm::ControllerJoints joints() const { return arm::toControllerJoints(state().joints); }
  /// The TCP in the active base [mm, deg].
  [[nodiscard]] arm::ControllerPose tool() const {
    const RobotState robot = state();
    return arm::toControllerPose(robot.base.inverse() * robot.flange * robot.tcp);
  }
  SimulatedController& controller() { return controller_; }

 private:
  struct Collector {
    SimulatedRobot& robot;
    void operator()(const Send& send) const { robot.heard_[send.client] += send.bytes; }
    void operator()(const CloseClient& close) const {
      robot.events_.push_back("x" + std::to_string(close.client));
    }
    void operator()(const OpenPort& open) const { robot.events_.push_back("+" + name(open.port)); }
    void operator()(const ClosePort& close) const { robot.events_.push_back("-" + name(close.port)); }
    void operator()(const LogLine& line) const { robot.log_.push_back(line); }
    static std::string name(Port port) { return port == Port::Script ? "script" : "status"; }
  };
  void collect() {
    for (const Output& output : controller_.takeOutputs()) std::visit(Collector{*this}, output);
  }

  SimulatedController controller_;
  Instant now_{};
  ClientId clients_ = 0;
  std::map<ClientId, std::string> heard_;
  std::vector<std::string> events_;
  std::vector<LogLine> log_;
};

/// A controller that has priority commands.
inline Settings withPriorityCommands() {
  Settings settings;
  settings.tmflow_version = "1.82";
  return settings;
}

/// What the controller sends, as it stands on the wire.
inline std::string entered(const std::string& message = "Listen1") {
  return protocol::encodeFrame("TMSCT", "0," + message);
}
inline std::string ok(const std::string& id) {
  return protocol::encodeFrame("TMSCT", id + ",OK");
}
inline std::string warned(const std::string& id, const std::string& lines) {
  return protocol::encodeFrame("TMSCT", id + ",OK;" + lines);
}
inline std::string error(const std::string& id, const std::string& lines) {
  return protocol::encodeFrame("TMSCT", id + ",ERROR;" + lines);
}
inline std::string tag(const std::string& data) {
  return protocol::encodeFrame("TMSTA", "01," + data);
}

}  // namespace cobot_command::simulator::test
