#include "cobot_command/blocks/check_sequence.h"

#include <utility>

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"
#include <fmt/format.h>

#include "cobot_command/CheckSequenceAction.h"

namespace cobot_command::ros_adapter {
namespace {

/// Absent when the message names a kind that there is not.
std::optional<blocks::SequenceStep> toStep(const cobot_command::SequenceStep& message,
                                           const Lookups& lookups) {
  using Message = cobot_command::SequenceStep;
  switch (message.kind) {
    case Message::MOVE_ABSOLUTE:
      return toGoal(message.move_absolute, lookups);
    case Message::MOVE_RELATIVE:
      return toGoal(message.move_relative, lookups);
    case Message::MOVE_CIRCLE:
      return toGoal(message.move_circle, lookups);
    case Message::CHANGE_BASE:
      return toGoal(message.change_base, lookups);
    case Message::CHANGE_TCP:
      return toGoal(message.change_tcp, lookups);
    default:
      return std::nullopt;
  }
}

}  // namespace

blocks::CheckSequenceGoal toGoal(const cobot_command::CheckSequenceGoal& message, const Lookups& lookups) {
  blocks::CheckSequenceGoal goal;
  goal.start_joints = message.start_joints;
  if (hasTooMany(goal, message.steps)) return goal;
  for (std::size_t i = 0; i < message.steps.size(); ++i) {
    if (auto step = toStep(message.steps[i], lookups)) {
      goal.steps.push_back(std::move(*step));
    } else if (goal.steps_fault.empty()) {
      goal.steps_fault = fmt::format("step {}: kind is {}; allowed: 0 to 4, as in SequenceStep.msg", i + 1,
                                     message.steps[i].kind);
      goal.faulty_step = static_cast<int>(i);
    }
  }
  return goal;
}

void fill(cobot_command::CheckSequenceResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillEnd(message, outcome);
  message.planned_duration = toRos(outcome.planned);
  fillSteps(message, outcome.detail.as<blocks::SequenceReport>(), site.joint_names);
}

void fill(cobot_command::CheckSequenceFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillPhase(message, progress);
}

template <>
struct ActionOf<blocks::CheckSequenceGoal> {
  using Type = cobot_command::CheckSequenceAction;
};
template std::unique_ptr<GoalListener> serve<blocks::CheckSequenceGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
