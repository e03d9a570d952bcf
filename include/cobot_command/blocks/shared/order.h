// What goes to the controller for a goal: lines of script, and what they mean.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {

/// Without queue tag and exit.
struct Order {
  std::vector<std::string> lines;
  /// So many lines in front of each, rising: there the controller is to tell that it has come so far.
  std::vector<std::size_t> marks;
  /// What the lines mean; absent when they are a raw script that says more than this layer knows.
  std::optional<std::vector<script::ScriptCommand>> commands;
  bool moves = false;     ///< a cancel has to stop the robot
  bool has_exit = false;  ///< its own lines end with an exit that has a number
  bool lets_go = false;   ///< a script with a resume: what was held goes on, and the arm may move
  bool pauses = false;    ///< a script with a Pause() of its own
  /// It moves the arm until it is told to end: no plan says where, and for how long.
  bool is_open_ended = false;
  bool stands_at_end = true;  ///< the robot stands when its tag comes; false: a script that sets velocities
  bool is_previewed = false;  ///< people see the path of its goal as a whole
  /// Nobody knows what the robot does when it goes unanswered: it is stopped then.
  bool stops_unanswered = false;
  bool takes_override = false;  ///< its speeds are those of its goal: slowed() counts for them
  double speed_share = 1.0;     ///< so much of these its lines have, (0, 1]
};

/// A line for each command, in this order; the arm moves.
[[nodiscard]] Order motionOrder(script::ScriptCommand command);
[[nodiscard]] Order motionOrder(std::vector<script::ScriptCommand> commands);
/// The same; the arm does not move.
[[nodiscard]] Order settingOrder(script::ScriptCommand command);
[[nodiscard]] Order settingOrder(std::vector<script::ScriptCommand> commands);
/// As motionOrder(), of a goal that gives its speed, in % or mm/s: that may be slowed().
[[nodiscard]] Order moveOrder(script::ScriptCommand command);

/// With `share` of its speeds, (0, 1], where it takes that; the times to top speed stay. Scripts have whole
/// numbers: rounded down, so that nothing is faster than asked for, but not below 1.
[[nodiscard]] Order slowed(Order order, double share);

}  // namespace cobot_command::blocks
