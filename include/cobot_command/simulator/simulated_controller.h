// The simulated TM controller: a complete peer, not a mock. Its inputs are bytes and time, its outputs bytes
// and the robot state.
//
// Owns no socket, no thread and no clock. Not thread-safe: one thread owns it. The same calls at the same
// times give bit-identical outputs and joint paths.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/simulator/operator_action.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

enum class Port { Script, Status };

/// Chosen by the owner of the sockets; never reused.
using ClientId = std::uint64_t;

/// Bytes for one client.
struct Send {
  Port port;
  ClientId client;
  std::string bytes;
};
/// The controller disconnects a client.
struct CloseClient {
  Port port;
  ClientId client;
};
/// The script port is open only while a project runs (TM 1.2); otherwise clients are refused. The status port
/// is opened once, in the constructor. The script port is also opened there if a project runs.
struct OpenPort {
  Port port;
};
/// Follows a CloseClient for each client of the port.
struct ClosePort {
  Port port;
};
/// One readable line of the traffic log.
struct LogLine {
  Instant time;
  std::string text;
};

using Output = std::variant<Send, CloseClient, OpenPort, ClosePort, LogLine>;

class SimulatedController {
 public:
  SimulatedController(const arm::ArmModel& arm, Settings settings, Instant now);
  ~SimulatedController();
  SimulatedController(SimulatedController&&) noexcept;
  SimulatedController& operator=(SimulatedController&&) noexcept;

  // --- Connections.
  /// The address, as "127.0.0.1", is only used for Settings::write_clients.
  void clientConnected(Port port, ClientId client, Instant now, std::string_view address = {});
  void clientDisconnected(Port port, ClientId client, Instant now);
  void received(Port port, ClientId client, std::string_view bytes, Instant now);

  // --- Time.
  /// Advances the robot to `now` and handles every event at its exact time, so the number of calls has no
  /// effect. Time never decreases; an earlier time counts as the latest one.
  void advance(Instant now);
  /// The latest time for the next advance(): a status frame is due, a motion ends, or a wait ends.
  /// Instant::max() if nothing will happen automatically.
  [[nodiscard]] Instant nextEvent() const;

  // --- Operator actions.
  /// An action without effect, such as pressing a pressed button, also counts as done.
  OperatorReply operate(const OperatorAction& action, Instant now);

  // --- Outputs.
  /// All outputs since the last call, in order.
  [[nodiscard]] std::vector<Output> takeOutputs();
  /// The true state of the robot at the time of the last call.
  [[nodiscard]] RobotState state() const;
  [[nodiscard]] const arm::ArmModel& arm() const;

 private:
  class Impl;  // src/simulator/controller_impl.h
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::simulator
