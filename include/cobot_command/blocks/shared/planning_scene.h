// Where a plan begins, for goals that are answered by planning.
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

/// Asked between two steps: true, when nobody waits for the plan any more; then any answer will do.
using GiveUp = std::function<bool()>;

struct PlanningScene {
  const arm::ArmModel* arm = nullptr;  ///< nullptr: no model is known
  /// The robot when the first command comes, as far as that is known; absent: nothing is.
  std::optional<planning::ScriptPlanner::Start> start;
  std::string why_unknown;         ///< the joints of the start, for people; empty: they are known
  GiveUp give_up;                  ///< may be empty: never
  tables::DataTables tables = {};  ///< as they are when the planning begins
  Detail chain = {};       ///< of the run that the goal is to join (GoalChain::end); none: it is the first
  PathSettings path = {};  ///< how paths are loaded
  std::shared_ptr<const path::DrivenPath> driven = {};  ///< of the last path; nullptr: none is known
  double feedrate = 1.0;                                ///< of paths
  double speed_share = 1.0;          ///< of the speeds that moves give, (0, 1]: the speed override
  bool is_pvt_refused = false;       ///< the controller has refused to enter one
  bool is_velocity_refused = false;  ///< the controller has refused to take velocities
  VelocityModes velocities = {};     ///< that may be used
  Duration jog_stop_time = std::chrono::milliseconds(200);  ///< that it needs to bring the arm to rest
  double angle_tolerance = 0.0017453;          ///< within this of a target a joint is there [rad]
  std::shared_ptr<ProgramGuide> program = {};  ///< of the robot in its cell; nullptr: it is in none
  int number = 1;                              ///< the goal would be so many-th of its block that is accepted
};

}  // namespace cobot_command::blocks
