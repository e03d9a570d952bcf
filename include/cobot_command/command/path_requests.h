// Requests for paths from outside their goals, and the answers.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace cobot_command::command {

struct TrackingSwitch {
  int object = 0;
  bool on = false;
  bool automatic = false;  ///< from now on it switches automatically to the state that the next goal requires
};

/// Feedrate: the time scale of paths, 0 to 125 %. 0: the running path is paused on the path, and no part of
/// it is lost. nullopt: the feedrate from before the pause.
struct FeedrateRequest {
  std::optional<double> percent;
  /// It also applies to the motions at the controller: the robot is stopped, and the rest is planned from
  /// where it stopped.
  bool restart = false;
};

struct FeedrateAnswer {
  bool success = false;
  int error_id = 0;
  std::string message;  ///< in plain words
  /// [%] of the motions that the controller has now; if it has none: of those that are sent next.
  double effective = 0;
  /// First point with the new feedrate, index in the array of its goal; -1: no point is left to send.
  int from_point = -1;
};

/// Called once: at once, or when the controller has answered.
using FeedrateReply = std::function<void(const FeedrateAnswer& answer)>;

}  // namespace cobot_command::command
