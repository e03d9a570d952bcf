// One command, planned before a byte of it is sent: refused by name, or how long it takes and where it ends.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/planning_scene.h"
#include "cobot_command/command/planning_job.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::command {

/// Where a command starts: what the robot and its frames will be then, as far as that is known.
struct Origin {
  planning::ScriptPlanner::Start start;
  std::optional<planning::ScriptPlanner> behind;  ///< of what is in front; it may blend into the command
  Duration arrival{};  ///< when the robot gets the command, by the time of `behind`
  /// Base and TCP were streamed or commanded, not only taken for those that a project starts with.
  bool frames_told = false;

  /// What is in front still moves the robot then; else the command starts from rest.
  [[nodiscard]] bool isBehindMotion() const { return behind && arrival < behind->duration(); }
};

struct Plan {
  Duration duration{};
  Duration start_delay{};                      ///< until its first motion begins, after it was sent
  Duration arrival{};                          ///< of the origin
  Origin end;                                  ///< where the next command starts
  std::optional<robot::Target> target;         ///< where its last motion leaves the robot, if that is certain
  arm::Pose tcp = arm::Pose::Identity();       ///< of the motions, in the flange [m]
  std::vector<motion::TrajectoryPtr> motions;  ///< of a command that moves: one, of a raw script: several
};

/// No plan when the start or the effect of a command is not known, or there is no model.
using Planned = Result<std::optional<Plan>, blocks::Failure>;

/// The answer to who asked for the plan of one command.
struct PlannedCommand {
  Origin origin;
  Planned plan;
  std::vector<arm::Pose> tool_path = {};  ///< of its motions: the TCP in the robot base, for people
};

/// It is what would be planned from `now`, but for the time that has passed since.
[[nodiscard]] bool isStillGood(const PlannedCommand& planned, const Origin& now);

/// `give_up`: may be empty; asked between two commands.
[[nodiscard]] Planned planFor(const arm::ArmModel* arm, const std::vector<script::ScriptCommand>& commands,
                              const Origin& origin, const blocks::GiveUp& give_up = {});

/// The lines of a command in that base, with so much of its speeds; refused when it needs one that is not
/// known.
[[nodiscard]] Result<blocks::Order, blocks::Failure> linesOf(const blocks::Command& command,
                                                             const std::optional<arm::Pose>& base,
                                                             double speed_share);

/// Of a command that begins at `origin`; refused when its lines are.
[[nodiscard]] Planned planFor(const arm::ArmModel* arm, const blocks::Command& command,
                              const std::optional<arm::Pose>& base, double speed_share,
                              const std::optional<Origin>& origin, const blocks::GiveUp& give_up);

/// Of its motions: poses of the TCP in the robot base, for people.
[[nodiscard]] std::vector<arm::Pose> toolPathOf(const Plan& plan, const arm::ArmModel& arm);

}  // namespace cobot_command::command
