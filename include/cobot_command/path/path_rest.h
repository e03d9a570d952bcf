// What is left of a motion that was planned, where the arm has come to stand on its way.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// To be planned again (PathPlanner::appendAgain) from where the arm stands. An arc, whose own place to pass
/// may lie behind the arm by now, gets another one on the same circle; its last millimetre is a line.
/// `time`: since the motion began, by its plan.
[[nodiscard]] PlannedPoint restOf(const PlannedPoint& point, Duration time, const arm::ArmModel& arm);

}  // namespace cobot_command::path
