// The simulated TM controller: bytes and time in, bytes and robot state out. A peer, not a mock.
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

/// Chosen by whoever owns the sockets; never used twice.
using ClientId = std::uint64_t;

/// Bytes for one client.
struct Send {
  Port port;
  ClientId client;
  std::string bytes;
};
/// The controller drops a client.
struct CloseClient {
  Port port;
  ClientId client;
};
/// The script port is served only while a project runs (TM 1.2): with it closed, clients are refused.
/// The status port is opened once, in the constructor; the script port there too when a project runs.
struct OpenPort {
  Port port;
};
/// Comes after a CloseClient for each client of the port.
struct ClosePort {
  Port port;
};
/// One line of the traffic log, for people.
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

  // --- The wire.
  /// The address, as "127.0.0.1", is for Settings::write_clients alone.
  void clientConnected(Port port, ClientId client, Instant now, std::string_view address = {});
  void clientDisconnected(Port port, ClientId client, Instant now);
  void received(Port port, ClientId client, std::string_view bytes, Instant now);

  // --- Time.
  /// Brings the robot to `now`, through every event on the way at its exact time: how often it is called
  /// changes nothing. Times never go back; an earlier one is taken as the latest seen.
  void advance(Instant now);
  /// When advance() has to be called at the latest: a status frame is due, a motion ends, a wait runs out.
  /// Instant::max() when nothing will happen by itself.
  [[nodiscard]] Instant nextEvent() const;

  // --- The operator's side of the controller.
  /// An action that changes nothing, like to press what is pressed, is done all the same.
  OperatorReply operate(const OperatorAction& action, Instant now);

  // --- What comes out.
  /// All outputs since the last call, in order.
  [[nodiscard]] std::vector<Output> takeOutputs();
  /// The robot's true state at the time of the last call.
  [[nodiscard]] RobotState state() const;
  [[nodiscard]] const arm::ArmModel& arm() const;

 private:
  class Impl;  // src/simulator/controller_impl.h
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::simulator
