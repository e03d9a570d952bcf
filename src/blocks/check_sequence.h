// A list of commands, checked and planned end to end before anything is sent: by the planner that also moves
// the simulated arm.
#pragma once

#include <optional>

#include "preflight.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/goal.h"
#include "cobot_command/blocks/outcome.h"

namespace cobot_command::blocks {

/// Done with a report of every step; or Rejected with the index of the first step that fails and its own
/// error, the reports ending with it. `origin`: where the sequence begins, but for the goal's start_joints;
/// absent: unknown.
[[nodiscard]] Outcome checkSequence(const CheckSequenceGoal& goal, const std::optional<arm::ArmModel>& arm,
                                    const std::optional<Origin>& origin);

}  // namespace cobot_command::blocks
