// The goal messages that other messages carry as their steps.
#pragma once

#include "cobot_command/ChangeBaseGoal.h"
#include "cobot_command/ChangeTCPGoal.h"
#include "cobot_command/MoveAbsoluteGoal.h"
#include "cobot_command/MoveCircleGoal.h"
#include "cobot_command/MoveRelativeGoal.h"
#include "cobot_command/WaitForInputGoal.h"
#include "cobot_command/blocks/check_sequence.h"
#include "cobot_command/blocks/waits/wait_for_input.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] blocks::MoveAbsoluteGoal toGoal(const cobot_command::MoveAbsoluteGoal& message,
                                              const Lookups& lookups);
[[nodiscard]] blocks::MoveRelativeGoal toGoal(const cobot_command::MoveRelativeGoal& message,
                                              const Lookups& lookups);
[[nodiscard]] blocks::MoveCircleGoal toGoal(const cobot_command::MoveCircleGoal& message,
                                            const Lookups& lookups);
[[nodiscard]] blocks::ChangeBaseGoal toGoal(const cobot_command::ChangeBaseGoal& message,
                                            const Lookups& lookups);
[[nodiscard]] blocks::ChangeTcpGoal toGoal(const cobot_command::ChangeTCPGoal& message,
                                           const Lookups& lookups);

[[nodiscard]] blocks::WaitForInputGoal toGoal(const cobot_command::WaitForInputGoal& message,
                                              const Lookups& lookups);

}  // namespace cobot_command::ros_adapter
