#include "cobot_command/blocks/program_control.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ProgramControlAction.h"

namespace cobot_command::ros_adapter {

blocks::ProgramControlGoal toGoal(const cobot_command::ProgramControlGoal& message,
                                  const Lookups& /*lookups*/) {
  return {message.command_id, message.command};
}

void fill(cobot_command::ProgramControlResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillCommandEnd(message, outcome);
}

void fill(cobot_command::ProgramControlFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillPhase(message, progress);
}

template <>
struct ActionOf<blocks::ProgramControlGoal> {
  using Type = cobot_command::ProgramControlAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ProgramControlGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
