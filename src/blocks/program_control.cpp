#include "cobot_command/blocks/program_control.h"

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

bool is(const ProgramControlGoal& goal, ProgramCommand command) {
  return goal.command == static_cast<int>(command);
}

}  // namespace

ErrorTable ProgramControlGoal::errors() {
  return ErrorTable()
      .thesisCommand()
      .echoedCommandId()
      .anyCommand()
      .shared(own_error::kNotListening,
              "the controller answered CPERR F1: the flow is not in a Listen node; only the controller "
              "checks this")
      .shared(interface_error::kInterrupted,
              "RESUME, and enabled data are out of sync; a sync_reaction has interrupted the robot because "
              "of this")
      .row(own_error::kOverrideZero, "The speed override is 0 %",
           "Raise it with change_speed_override: the robot then continues",
           "RESUME, and a speed override of 0 pauses the robot")
      .row(own_error::kProgramCommandUnknown, "Command unknown", "Use 0 (Pause) or 1 (Resume)",
           "command is neither 0 nor 1");
}

GoalTraits traitsOf(const ProgramControlGoal& goal) {
  GoalTraits traits;
  traits.way = Way::Beside;
  traits.command_id = goal.command_id;
  traits.tried_anyway = true;
  traits.halts = is(goal, ProgramCommand::Pause);
  traits.resumes = is(goal, ProgramCommand::Resume);
  return traits;
}

std::vector<Failure> check(const ProgramControlGoal& goal) {
  ParameterChecks checks;
  checks.commandId(goal.command_id, kNoCommandId);
  checks.require(is(goal, ProgramCommand::Pause) || is(goal, ProgramCommand::Resume),
                 own_error::kProgramCommandUnknown, fmt::format("command is {}", goal.command));
  return std::move(checks).violations();
}

Order orderOf(const ProgramControlGoal& goal, const arm::Pose& /*base*/) {
  Order order = settingOrder(is(goal, ProgramCommand::Pause) ? script::ScriptCommand(script::Pause{})
                                                             : script::Resume{});
  order.stops_unanswered = true;
  return order;
}

}  // namespace cobot_command::blocks
