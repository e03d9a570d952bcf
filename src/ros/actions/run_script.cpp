#include "cobot_command/blocks/run_script.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/RunScriptAction.h"

namespace cobot_command::ros_adapter {

blocks::RunScriptGoal toGoal(const cobot_command::RunScriptGoal& message, const Lookups& /*lookups*/) {
  return {message.script, message.await_motion != 0, message.reply_timeout, message.buffer_mode};
}

void fill(cobot_command::RunScriptResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillCommandEnd(message, outcome);
}

void fill(cobot_command::RunScriptFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillCommandTurn(message, progress);
}

template <>
struct ActionOf<blocks::RunScriptGoal> {
  using Type = cobot_command::RunScriptAction;
};
template std::unique_ptr<GoalListener> serve<blocks::RunScriptGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
