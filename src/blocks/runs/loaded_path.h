// What planning hands to the run of a path: its plan, and the planner that goes on behind it.
#pragma once

#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::blocks {

struct LoadedPath {
  path::PathPlanner planner;  ///< behind the goal's points
  path::PathPlan plan;        ///< of the goal's points
};

}  // namespace cobot_command::blocks
