#include "cobot_command/blocks/ways_back/retrace.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/RetraceAction.h"

namespace cobot_command::ros_adapter {

blocks::RetraceGoal toGoal(const cobot_command::RetraceGoal& message, const Lookups& /*lookups*/) {
  blocks::RetraceGoal goal;
  goal.point = message.point;
  goal.method_id = message.method_id;
  goal.speed = message.speed;
  goal.buffer_mode = message.buffer_mode;
  return goal;
}

void fill(cobot_command::RetraceResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillEnd(message, outcome);
  fillArrival(message, outcome);
}

void fill(cobot_command::RetraceFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
  message.progress = progress.fraction;
  message.remaining = toRos(progress.remaining);
}

template <>
struct ActionOf<blocks::RetraceGoal> {
  using Type = cobot_command::RetraceAction;
};
template std::unique_ptr<GoalListener> serve<blocks::RetraceGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
