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
/// While the arm moves, the simulated time jumps from event to event, with the sockets served in between;
/// while it stands, time goes on as real time does, as nothing is worth hurrying for. It also falls back to
/// real time while a client is slow to take its status frames, so that none is flooded. When bytes arrive
/// depends on the machine, so only what follows from them is the same in every run.
inline constexpr double kAsFastAsPossible = 0;

struct SimulatorOptions {
  std::string bind_address = "127.0.0.1";  ///< whom to serve; "0.0.0.0": every network of this machine
  int script_port = 5890;                  ///< 0: any free one, kept while the project stands still
  int status_port = 5891;                  ///< 0: any free one
  double time_scale = 1;  ///< simulated seconds in a real one, within the limits above, or kAsFastAsPossible
  Duration state_period{};   ///< real time between two states for the observer; 0: none
  bool tells_states = true;  ///< from the start on; see tellStates()
};

/// The real ones, also where any was asked for.
struct SimulatorPorts {
  int script = 0;
  int status = 0;
};

/// Why a simulator did not start: what was found, what is allowed, what to do.
struct SimulatorError {
  enum class Kind {
    BadOption,   ///< another value is needed
    Unavailable  ///< the machine refuses for now: a port is in use, for instance
  };
  Kind kind = Kind::Unavailable;
  std::string message;
};

/// Thread-safe, but for what is said of start() and stop().
class SimulatorRuntime {
 public:
  /// Called on the simulator's thread; may be empty; must not throw, and not wait for long.
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

  /// The power goes off: clients are dropped, ports given back, the thread ends. The observer is not called
  /// any more once this returns. It never waits for the network. Not from the observer.
  void stop();

  /// Whether the observer is told states, each period and the first at once: none are made while nobody wants
  /// them. Means nothing without an observer of states and a period.
  void tellStates(bool wanted);

  /// An operator's action, for instance `controller.operate(StopProject{}, now)`. False, and it is not done,
  /// once stop() has begun. `finished` is called on the simulator's thread when all that comes of it is done:
  /// bytes are on their way, ports are open or closed.
  bool post(Operation operation, std::function<void()> finished = {});

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::runtime
