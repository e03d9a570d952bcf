// CBT_ProgramControl (thesis 5.3.7).

#include "parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

bool is(const ProgramControlGoal& goal, ProgramCommand command) {
  return goal.command == static_cast<int>(command);
}

}  // namespace

std::vector<Failure> check(const ProgramControlGoal& goal) {
  ParameterChecks checks;
  checks.commandId(goal.command_id, kNoCommandId);
  checks.require(is(goal, ProgramCommand::Pause) || is(goal, ProgramCommand::Resume),
                 own_error::kProgramCommandUnknown, fmt::format("command is {}", goal.command));
  return std::move(checks).violations();
}

script::ScriptCommand commandOf(const ProgramControlGoal& goal) {
  if (is(goal, ProgramCommand::Pause)) return script::Pause{};
  return script::Resume{};
}

}  // namespace cobot_command::blocks
