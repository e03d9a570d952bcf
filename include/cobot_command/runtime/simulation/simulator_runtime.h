// The simulated controller with real sockets and a clock, on a thread of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::runtime {

inline constexpr double kSlowestTimeScale = 0.01;
inline constexpr double kFastestTimeScale = 100;
/// While the arm moves, the simulated time jumps from event to event, and the sockets are served in between.
/// While the arm is at standstill, the simulated time follows the real time, because nothing needs to be
/// faster. It also follows the real time while a client is slow to read its status frames, so that no client
/// is flooded. The arrival times of bytes depend on the machine, so only their consequences are the same in
/// every run.
inline constexpr double kAsFastAsPossible = 0;

struct SimulatorOptions {
  std::string bind_address = "127.0.0.1";  ///< address to serve; "0.0.0.0": all networks of this machine
  int script_port = 5890;  ///< 0: any free port, which stays reserved while the project does not run
  int status_port = 5891;  ///< 0: any free port
  /// Simulated seconds per real second, within the limits above, or kAsFastAsPossible.
  double time_scale = 1;
  Duration state_period{};   ///< real time between two states for the observer; 0: none
  bool tells_states = true;  ///< initial value; see tellStates()
};

/// The actual ports, also if any free port was requested.
struct SimulatorPorts {
  int script = 0;
  int status = 0;
};

/// Why a simulator did not start: what was found, what is allowed, what to do.
struct SimulatorError {
  enum class Kind {
    BadOption,   ///< the option needs another value
    Unavailable  ///< the machine refuses at present: for example, a port is in use
  };
  Kind kind = Kind::Unavailable;
  std::string message;
};

/// Thread-safe, except as stated for start() and stop().
class SimulatorRuntime {
 public:
  /// Called on the simulator's thread. The functions may be empty. They must not throw and must not wait for
  /// long.
  struct Observer {
    std::function<void(const simulator::RobotState&)> state;
    std::function<void(const simulator::LogLine&)> log;
  };
  using Operation = std::function<void(simulator::SimulatedController&, Instant now)>;

  SimulatorRuntime(arm::ArmModel arm, simulator::Settings settings, SimulatorOptions options,
                   Observer observer = {});
  ~SimulatorRuntime();  ///< stop()
  SimulatorRuntime(const SimulatorRuntime&) = delete;
  SimulatorRuntime& operator=(const SimulatorRuntime&) = delete;

  /// When it returns, clients are served: on the status port, and on the script port while a project runs.
  /// Precondition: called once, before anything else.
  [[nodiscard]] Result<SimulatorPorts, SimulatorError> start();

  /// Switches the power off: clients are disconnected, ports are released, the thread ends. The observer is
  /// not called any more after this returns. It never waits for the network. Must not be called by the
  /// observer.
  void stop();

  /// Whether the observer gets states, the first one at once and then one in each period. No states are
  /// created while they are not wanted. No effect without an observer for states or without a period.
  void tellStates(bool wanted);

  /// An action of the operator, for example `controller.operate(StopProject{}, now)`. False: stop() has
  /// begun, and the action is not carried out. `finished` is called on the simulator's thread when the action
  /// has taken full effect: bytes are being sent, ports are open or closed.
  bool post(Operation operation, std::function<void()> finished = {});

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::runtime
