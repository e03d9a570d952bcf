#include "cobot_command/blocks/set_output.h"

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {
namespace {

bool isAnalog(const SetOutputGoal& goal) {
  return goal.kind == static_cast<int>(OutputKind::Analog);
}

void checkAnalog(ParameterChecks& checks, const SetOutputGoal& goal) {
  const bool is_there = script::ioModule(goal.module) == script::IoModule::ControlBox && goal.output == 0;
  checks.require(is_there, own_error::kOutputInvalid,
                 fmt::format("analog output {} of module '{}'; allowed: 0 of ControlBox", goal.output,
                             foreignText(goal.module, kQuoteLimit)));
  checks.require(isWithin(goal.value, -script::kMostVolt, script::kMostVolt), own_error::kOutputValue,
                 fmt::format("value is {} V", goal.value));
}

void checkDigital(ParameterChecks& checks, const SetOutputGoal& goal) {
  checks.io("output", goal.module, goal.output, own_error::kOutputInvalid);
  checks.require(goal.value == 0 || goal.value == 1, own_error::kOutputValue,
                 fmt::format("value is {}", goal.value));
}

}  // namespace

ErrorTable SetOutputGoal::errors() {
  return ErrorTable()
      .anyCommand()
      .turn()
      .condition(motion_error::kReceiveReply,
                 "the controller did not answer the script in time; unless it was at_once, the robot is sent "
                 "a stop command")
      .shared({own_error::kOutputInvalid, own_error::kOutputValue});
}

GoalTraits traitsOf(const SetOutputGoal& goal) {
  GoalTraits traits;
  traits.way = goal.at_once ? Way::Beside : Way::Queue;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  return traits;
}

std::vector<Failure> check(const SetOutputGoal& goal) {
  ParameterChecks checks;
  if (!goal.at_once) checks.bufferMode(goal.buffer_mode);
  if (isAnalog(goal)) {
    checkAnalog(checks, goal);
  } else if (goal.kind == static_cast<int>(OutputKind::Digital)) {
    checkDigital(checks, goal);
  } else {
    checks.require(false, own_error::kOutputValue, fmt::format("kind is {}", goal.kind));
  }
  return std::move(checks).violations();
}

Order orderOf(const SetOutputGoal& goal, const arm::Pose& /*base*/) {
  if (isAnalog(goal)) return settingOrder(script::WriteAnalogOutput{goal.value, goal.at_once});
  script::WriteOutput write;
  write.module = *script::ioModule(goal.module);
  write.index = goal.output;
  write.on = goal.value == 1;
  write.instant = goal.at_once;
  return settingOrder(write);
}

}  // namespace cobot_command::blocks
