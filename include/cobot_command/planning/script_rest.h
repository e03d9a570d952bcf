// The remaining part of planned motions after the arm has stopped on the path: script lines that lead to the
// same targets on the same path. Relative motions are converted, because an offset would now start from
// another position.
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

/// Script lines as planned, with a trajectory for each line that moves the arm.
struct PlannedLines {
  std::vector<script::ScriptCommand> commands;
  std::vector<motion::TrajectoryPtr> motions;
  ScriptPlanner::Start start;  ///< base and TCP are those of the lines
};

/// The position of the arm on the lines.
struct PlaceOnLines {
  std::size_t motion = 0;
  Duration time{};  ///< since the start of that motion
};

/// Why the remaining part of such lines cannot be determined; std::nullopt if it can. Lines that move the arm
/// may be combined with outputs only. Lines that change base, TCP or load are accepted if no line moves the
/// arm. Lines without motion are repeated as a whole. Other lines, such as waits, are not accepted.
[[nodiscard]] std::optional<std::string> whyNotResumable(const PlannedLines& lines);

/// The lines after the place: the rest of the current motion and all lines after it. Empty: nothing remains.
/// A nearly straight rest of an arc becomes a line. The rest of an arc angle of more than 300 degrees becomes
/// several arcs, and the arm stops between them. Precondition: whyNotResumable() is std::nullopt.
[[nodiscard]] std::vector<script::ScriptCommand> restOf(const PlannedLines& lines, const PlaceOnLines& place,
                                                        const arm::ArmModel& arm);

}  // namespace cobot_command::planning
