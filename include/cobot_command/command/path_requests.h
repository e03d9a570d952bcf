// What is asked of paths from outside of their goals, and what is answered.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace cobot_command::command {

struct TrackingSwitch {
  int object = 0;
  bool on = false;
  bool automatic = false;  ///< from now on it switches itself to what the next goal wants
};

/// How fast the time of paths runs, 0 to 125 %; 0: the path under way is stopped on its way, and nothing of
/// it is lost. Nothing: as it was before it was stopped.
struct FeedrateRequest {
  std::optional<double> percent;
  /// Also of what the controller has: the robot is stopped, and the rest planned from where it stands.
  bool restart = false;
};

struct FeedrateAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;   ///< in plain words
  double effective = 0;  ///< [%] of what the controller has now; of what is sent next, when it has nothing
  int from_point =
      -1;  ///< the first point that has the new feedrate, in the array of its goal; -1: none waits
};

/// Called once: at once, or when the controller has answered.
using FeedrateReply = std::function<void(const FeedrateAnswer& answer)>;

}  // namespace cobot_command::command
