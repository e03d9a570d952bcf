// What is left of motions that were planned, where the arm has come to stand on its way: script lines that
// bring it to the same targets by the same way, wherever an offset would begin from another place now.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::planning {

/// Lines as they were planned, with a motion for each of them that moves the arm.
struct PlannedLines {
  std::vector<script::ScriptCommand> commands;
  std::vector<motion::TrajectoryPtr> motions;
  ScriptPlanner::Start start;  ///< base and TCP are those of the lines
};

/// Where the arm is on them.
struct PlaceOnLines {
  std::size_t motion = 0;
  Duration time{};  ///< of that motion, since it began
};

/// Why what is left of such lines could not be told; nothing: it can. Lines that move the arm may stand with
/// outputs, and not with what changes base, TCP or load, waits, or speaks of itself; those that do not move
/// it are taken up as a whole.
[[nodiscard]] std::optional<std::string> whyNotResumable(const PlannedLines& lines);

/// Behind the place: the motion there to its end, and all that follows it. Empty: nothing is left. The end of
/// an arc that is next to straight is a line; what is left of an arc angle, and is more than 300 degrees,
/// becomes several arcs, between which the arm rests. Precondition: whyNotResumable() is nothing.
[[nodiscard]] std::vector<script::ScriptCommand> restOf(const PlannedLines& lines, const PlaceOnLines& place,
                                                        const arm::ArmModel& arm);

}  // namespace cobot_command::planning
