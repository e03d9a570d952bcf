// Where a plan begins, for goals that are answered by planning.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::blocks {

struct PlanningScene {
  const arm::ArmModel* arm = nullptr;  ///< nullptr: no model is known
  /// The robot when the first command comes, as far as that is known; absent: nothing is.
  std::optional<planning::ScriptPlanner::Start> start;
};

}  // namespace cobot_command::blocks
