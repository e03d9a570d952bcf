#include "cobot_command/blocks/waits/wait_time.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/WaitTimeAction.h"

namespace cobot_command::ros_adapter {

blocks::WaitTimeGoal toGoal(const cobot_command::WaitTimeGoal& message, const Lookups& /*lookups*/) {
  return {message.time, message.buffer_mode};
}

void fill(cobot_command::WaitTimeResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillEnd(message, outcome);
  message.actual_duration = toRos(outcome.actual);
}

void fill(cobot_command::WaitTimeFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
  message.remaining = toRos(progress.remaining);
}

template <>
struct ActionOf<blocks::WaitTimeGoal> {
  using Type = cobot_command::WaitTimeAction;
};
template std::unique_ptr<GoalListener> serve<blocks::WaitTimeGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
