// The remaining part of a planned motion after the arm has stopped on the path.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// The remaining motion, to be planned again (PathPlanner::appendAgain) from the position of the arm. An arc
/// gets another via point on the same circle, because the arm may have passed the original one. A nearly
/// straight rest of an arc (motion::isNextToStraight) becomes a line. `time`: since the start of the motion,
/// in its plan.
[[nodiscard]] PlannedPoint restOf(const PlannedPoint& point, Duration time, const arm::ArmModel& arm);

}  // namespace cobot_command::path
