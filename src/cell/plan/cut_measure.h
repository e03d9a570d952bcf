// How far two halves of a step are from the path of the whole.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/plan/step_cut.h"

namespace cobot_command::cell {

/// What is cut.
struct CutScene {
  const arm::ArmModel& arm;
  const PlannedMotion& whole;
  double speed_override = 1.0;
  double progress = 0.0;  ///< of the whole, where it is cut
};

/// When so much of the way is done, to the nanosecond.
[[nodiscard]] Duration timeOfProgress(const motion::Trajectory& motion, double progress);

/// Nothing: the halves break the rules of their blocks, or cannot be planned.
[[nodiscard]] std::optional<CutMeasure> measureCut(const CutScene& scene, const StepGoal& before,
                                                   const StepGoal& behind);

}  // namespace cobot_command::cell
