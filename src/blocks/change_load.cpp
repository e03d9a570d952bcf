#include "cobot_command/blocks/change_load.h"

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
ErrorTable ChangeLoadGoal::errors() {
  return ErrorTable().anyCommand().turn().row(own_error::kLoadRange, "Load range: 0~14 kg", kSetInRange,
                                              "weight is negative, above 14, or not a number");
}

GoalTraits traitsOf(const ChangeLoadGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  return traits;
}

std::vector<Failure> check(const ChangeLoadGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.require(isWithin(goal.weight, 0, kMaxWeight), own_error::kLoadRange,
                 fmt::format("weight is {}", goal.weight));
  return std::move(checks).violations();
}

Order orderOf(const ChangeLoadGoal& goal, const arm::Pose& /*base*/) {
  return settingOrder(script::ChangeLoad{goal.weight});
}

}  // namespace cobot_command::blocks
