#include "cobot_command/blocks/ways_back/return_to_primary.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ReturnToPrimaryAction.h"

namespace cobot_command::ros_adapter {

blocks::ReturnToPrimaryGoal toGoal(const cobot_command::ReturnToPrimaryGoal& message,
                                   const Lookups& /*lookups*/) {
  blocks::ReturnToPrimaryGoal goal;
  goal.return_mode = message.return_mode;
  goal.trajectory_mode = message.trajectory_mode;
  goal.speed = message.speed;
  goal.distance_limit = message.distance_limit;
  goal.allow_differences = message.allow_differences != 0;
  return goal;
}

void fill(cobot_command::ReturnToPrimaryResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
  fillArrival(message, outcome);
}

void fill(cobot_command::ReturnToPrimaryFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillPhase(message, progress);
  message.progress = progress.fraction;
  message.remaining = toRos(progress.remaining);
  message.remaining_distance = progress.distance_mm.value_or(-1);
}

template <>
struct ActionOf<blocks::ReturnToPrimaryGoal> {
  using Type = cobot_command::ReturnToPrimaryAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ReturnToPrimaryGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
