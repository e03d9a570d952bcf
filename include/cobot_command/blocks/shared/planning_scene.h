// Start and conditions of a plan, for goals that are answered by planning.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/common/path_settings.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/velocity_modes.h"
#include "cobot_command/path/driven_path.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::blocks {

class ProgramGuide;

/// Called between two steps; true: the plan is no longer needed, and any answer is accepted.
using GiveUp = std::function<bool()>;

struct PlanningScene {
  const arm::ArmModel* arm = nullptr;  ///< nullptr: the model is unknown
  /// The robot when the first command starts, as far as that is known; nullopt: unknown.
  std::optional<planning::ScriptPlanner::Start> start;
  /// Why the joints at the start are unknown, for people; empty: they are known.
  std::string why_unknown;
  GiveUp give_up;                  ///< may be empty: the planning is never given up
  tables::DataTables tables = {};  ///< at the start of the planning
  Detail chain = {};               ///< of the run that the goal joins (GoalChain::end); none: it is the first
  PathSettings path = {};          ///< how paths are loaded
  std::shared_ptr<const path::DrivenPath> driven = {};  ///< of the last path; nullptr: unknown
  double feedrate = 1.0;                                ///< of paths
  double speed_share = 1.0;          ///< the speed override: share of the speeds of moves, (0, 1]
  bool is_pvt_refused = false;       ///< the controller has refused to enter a PVT
  bool is_velocity_refused = false;  ///< the controller has refused velocities
  VelocityModes velocities = {};     ///< velocities that may be used
  Duration jog_stop_time = std::chrono::milliseconds(200);  ///< time it needs to bring the arm to rest
  double angle_tolerance = 0.0017453;          ///< a joint within this of its target has reached it [rad]
  std::shared_ptr<ProgramGuide> program = {};  ///< of the robot in its cell; nullptr: it is in no cell
  int number = 1;  ///< sequence number this goal would get within its block, if accepted
};

}  // namespace cobot_command::blocks
