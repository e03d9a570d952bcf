// The lines of script that are sent to the controller for a goal, and their meaning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/script/script_command.h"

namespace cobot_command::blocks {

/// Without the queue tag and the exit of this layer.
struct Order {
  std::vector<std::string> lines;
  /// Numbers of lines (ascending) after which a queue tag is inserted that reports the progress.
  std::vector<std::size_t> marks;
  /// Meaning of the lines; nullopt: a raw script that this layer does not understand completely.
  std::optional<std::vector<script::ScriptCommand>> commands;
  bool moves = false;     ///< a cancel must stop the robot
  bool has_exit = false;  ///< its own lines end with an exit that has a number
  bool lets_go = false;   ///< a script with a resume: a paused command continues, and the arm may move
  bool pauses = false;    ///< a script with a Pause() of its own
  /// It moves the arm until a command ends it: no plan gives the place and the duration.
  bool is_open_ended = false;
  /// The robot is at standstill when its tag returns; false: a script that sets velocities.
  bool stands_at_end = true;
  bool is_previewed = false;  ///< the path of its whole goal is shown to people
  /// Without an answer it is unknown what the robot does: it is stopped then.
  bool stops_unanswered = false;
  bool takes_override = false;  ///< its speeds are those of its goal: slowed() applies to them
  double speed_share = 1.0;     ///< share of these speeds that its lines have, (0, 1]
};

/// One line for each command, in this order; the arm moves.
[[nodiscard]] Order motionOrder(script::ScriptCommand command);
[[nodiscard]] Order motionOrder(std::vector<script::ScriptCommand> commands);
/// The same for commands that do not move the arm.
[[nodiscard]] Order settingOrder(script::ScriptCommand command);
[[nodiscard]] Order settingOrder(std::vector<script::ScriptCommand> commands);
/// As motionOrder(), for a goal that gives its speed in % or mm/s: slowed() applies to it.
[[nodiscard]] Order moveOrder(script::ScriptCommand command);

/// The order with `share`, (0, 1], of its speeds, if it has takes_override; the times to top speed stay.
/// Scripts have integers: speeds are rounded down, so that no motion is faster than requested, but not below
/// 1.
[[nodiscard]] Order slowed(Order order, double share);

}  // namespace cobot_command::blocks
