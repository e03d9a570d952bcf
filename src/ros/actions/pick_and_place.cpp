#include "cobot_command/blocks/pick_and_place.h"

#include <utility>

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/PickAndPlaceAction.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

blocks::PickAndPlaceStep toStep(const cobot_command::PickAndPlaceStep& message, const Lookups& lookups) {
  blocks::PickAndPlaceStep step;
  step.move = toGoal(message.move, lookups);
  if (!message.output.module.empty()) {
    step.output.emplace();
    step.output->module = message.output.module;
    step.output->output = message.output.output;
    step.output->value = message.output.value != 0 ? 1 : 0;
  }
  if (!message.input.module.empty()) {
    step.input = toGoal(message.input, lookups);
    step.input->buffer_mode = 0;  // that of the whole goal counts
  }
  step.dwell = message.dwell;
  return step;
}

}  // namespace

blocks::PickAndPlaceGoal toGoal(const cobot_command::PickAndPlaceGoal& message, const Lookups& lookups) {
  blocks::PickAndPlaceGoal goal;
  goal.cycles = message.cycles;
  goal.buffer_mode = message.buffer_mode;
  goal.check_only = message.check_only != 0;
  if (message.steps_file.empty()) {
    if (hasTooMany(goal, message.steps)) return goal;
    for (const auto& step : message.steps) goal.steps.push_back(toStep(step, lookups));
    return goal;
  }
  if (!message.steps.empty()) {
    goal.steps_fault = "both steps_file and steps are given; give one of them";
    return goal;
  }
  auto steps = lookups.steps(message.steps_file);
  if (!steps) {
    goal.steps_fault = foreignText(message.steps_file) + ": the file was not read within the time limit";
  } else if (*steps) {
    goal.steps = std::move(**steps);
  } else {
    goal.steps_fault = steps->error();
  }
  return goal;
}

void fill(cobot_command::PickAndPlaceResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillEnd(message, outcome);
  message.planned_duration = toRos(outcome.planned);
  message.actual_duration = toRos(outcome.actual);
  const auto& report = outcome.detail.as<blocks::CycleReport>();
  fillSteps(message, report, site.joint_names);
  message.cycles_done = report.cycles_done;
  const auto failed = static_cast<std::size_t>(report.failed_step);
  if (report.failed_step < 0 || failed >= report.steps.size()) return;
  message.step_error_id = report.steps[failed].error_id;
  message.step_error_description = report.steps[failed].error_description;
}

void fill(cobot_command::PickAndPlaceFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillMotion(message, progress);
  const auto& place = progress.detail.as<blocks::CyclePlace>();
  message.step = place.step;
  message.cycle = place.cycle;
}

template <>
struct ActionOf<blocks::PickAndPlaceGoal> {
  using Type = cobot_command::PickAndPlaceAction;
};
template std::unique_ptr<GoalListener> serve<blocks::PickAndPlaceGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
