#include "cobot_command/blocks/pick_and_place.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "runs/pick_and_place_run.h"
#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/blocks/check_sequence.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMaxDwell = 3600;

/// What is wrong with a step besides its move.
Failure blame(int error_id, std::string found, std::size_t index) {
  return {error_id, std::move(found), "", Detail(CycleReport{blaming(index), 0})};
}

/// Its move cannot be made.
Failure moveRefused(const PickAndPlaceGoal& goal, std::size_t index, const std::vector<Failure>& own) {
  Failure failure = stepRefused(index, goal.steps.size(), toRejection(kBlock<MoveAbsoluteGoal>, own));
  failure.detail = Detail(CycleReport{failure.detail.as<SequenceReport>(), 0});
  return failure;
}

/// What follows a move has the errors of its own block.
template <class Part>
void checkPart(const Part& part, std::size_t index, std::vector<Failure>& failures) {
  for (const Failure& failure : check(part)) {
    failures.push_back(blame(failure.error_id, fmt::format("step {}: {}", index + 1, failure.found), index));
  }
}

void checkStep(const PickAndPlaceGoal& goal, std::size_t index, std::vector<Failure>& failures) {
  const PickAndPlaceStep& step = goal.steps[index];
  const std::size_t number = index + 1;
  if (const auto own = check(step.move); !own.empty()) {
    failures.push_back(moveRefused(goal, index, own));
  }
  if (!isWithin(step.dwell, 0, kMaxDwell)) {
    failures.push_back(blame(own_error::kDwellRange,
                             fmt::format("the dwell of step {} is {} s", number, step.dwell), index));
  }
  if (step.output) checkPart(*step.output, index, failures);
  if (step.input) checkPart(*step.input, index, failures);
  if (step.move.blending_enable && (step.dwell > 0 || step.output || step.input)) {
    failures.push_back(blame(own_error::kBlendBeforeDwell, fmt::format("step {}", number), index));
  }
}

/// Behind an exit the controller takes nothing more, so it is only for the end of all.
void checkExits(const PickAndPlaceGoal& goal, std::vector<Failure>& failures) {
  for (std::size_t i = 0; i < goal.steps.size(); ++i) {
    if (!goal.steps[i].move.exit_node) continue;
    if (i + 1 < goal.steps.size()) {
      failures.push_back(
          blame(own_error::kExitBeforeEnd, fmt::format("step {} of {}", i + 1, goal.steps.size()), i));
    } else if (goal.cycles == 0) {
      failures.push_back(blame(own_error::kExitBeforeEnd, "cycles is 0: there is no last cycle", i));
    } else if (goal.steps[i].output || goal.steps[i].input) {
      failures.push_back(blame(own_error::kExitBeforeEnd,
                               fmt::format("step {} has an output or an input after its move", i + 1), i));
    } else {
      continue;
    }
    return;
  }
}

/// Its steps, which come round when there is more than one cycle.
CheckSequenceGoal asSequence(const PickAndPlaceGoal& goal) {
  CheckSequenceGoal sequence;
  for (const PickAndPlaceStep& step : goal.steps) sequence.steps.emplace_back(step.move);
  sequence.comes_round = goal.cycles != 1;
  return sequence;
}

}  // namespace

ErrorTable PickAndPlaceGoal::errors() {
  return ErrorTable()
      .turn()
      .underInterface()
      .shared({motion_error::kNotConnected, motion_error::kLinkDropped, own_error::kStartUnknown,
               own_error::kNoModel, own_error::kPlanningBudget, own_error::kShutDown})
      .shared(own_error::kStepCount, "there are no steps, or more than 50")
      .shared({own_error::kStepRefused})
      .row(own_error::kStepFailed, "Step failed", kExecuteAgain,
           "a move of the cycle failed in execution, or its input did not change in time; see the "
           "description for the error and the step")
      .row(own_error::kDwellRange, "Dwell range: 0~3600 s", kSetInRange,
           "the dwell of a step is negative, above 3600, or not a number")
      .row(own_error::kCycleRange, "Cycles range: 0~1000000", kSetInRange,
           "cycles is negative or above 1000000; 0 means until cancelled")
      .shared(own_error::kOutputInvalid, "the output of a step is of another module, or has no such number")
      .shared(
          own_error::kOutputValue,
          "cannot occur through ROS, where outputs are on or off: the value of a step's output is invalid")
      .shared(own_error::kInputInvalid, "the input of a step is of another module, or has no such number")
      .shared(own_error::kWaitRange,
              "the timeout of a step's input is negative, above 86400, or not a number; 0 means no timeout")
      .row(own_error::kStepsUnreadable, "Steps cannot be read",
           "Check the path of the file, and compare its format with config/pick_and_place.yaml",
           "steps_file does not exist, is not YAML, or has fields that a step does not have")
      .row(own_error::kOutputFailed, "Output not set", "Check that the controller has this output",
           "the controller refused or did not answer the line that sets an output, or it could not be sent; "
           "see the description")
      .row(own_error::kBlendBeforeDwell, "Blending must be disabled before an output, an input or a dwell",
           "Disable blending_enable of the step",
           "a step with blending_enable has an output, an input or a dwell")
      .row(own_error::kExitBeforeEnd, "Only the last step of the last cycle may leave the Listen node",
           "Remove exit_node from the step, or its output and input; give a number of cycles",
           "exit_node of a step that is not the last, of one with an output or an input, or with cycles 0");
}

GoalTraits traitsOf(const PickAndPlaceGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.may_move = true;
  traits.check_only = goal.check_only;
  return traits;
}

std::vector<Failure> check(const PickAndPlaceGoal& goal) {
  std::vector<Failure> failures;
  if (!goal.steps_fault.empty()) {
    failures.push_back({own_error::kStepsUnreadable, goal.steps_fault, ""});
  } else if (goal.steps.empty() || goal.steps.size() > PickAndPlaceGoal::kMostSteps) {
    failures.push_back(
        {own_error::kStepCount, foundSteps(goal.steps.size(), PickAndPlaceGoal::kMostSteps), ""});
  }
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  checks.require(goal.cycles >= 0 && goal.cycles <= kMaxCycles, own_error::kCycleRange,
                 fmt::format("cycles is {}", goal.cycles));
  for (Failure& failure : std::move(checks).violations()) failures.push_back(std::move(failure));
  for (std::size_t i = 0; i < goal.steps.size() && failures.empty(); ++i) {
    checkStep(goal, i, failures);
  }
  checkExits(goal, failures);
  return failures;
}

std::optional<Failure> findMovedFrame(const PickAndPlaceGoal& goal, const FrameFinder& finder) {
  for (std::size_t i = 0; i < goal.steps.size(); ++i) {
    if (const auto moved = findMovedFrame(goal.steps[i].move, finder)) {
      return moveRefused(goal, i, {*moved});
    }
  }
  return std::nullopt;
}

std::optional<Duration> plannedCycle(const PickAndPlaceGoal& goal, const std::vector<StepReport>& steps) {
  if (steps.size() < goal.steps.size()) return std::nullopt;
  Duration motion{};
  Duration dwells{};
  for (std::size_t i = 0; i < goal.steps.size(); ++i) {
    motion = std::max(motion, steps[i].start + steps[i].duration);
    dwells += fromSeconds(goal.steps[i].dwell);
  }
  return motion + dwells;
}

Outcome plan(const PickAndPlaceGoal& goal, const PlanningScene& scene) {
  Outcome outcome = plan(asSequence(goal), scene);
  outcome.detail = Detail(CycleReport{outcome.detail.as<SequenceReport>(), 0});
  if (outcome.ending != Ending::Rejected) {
    outcome.planned = plannedCycle(goal, outcome.detail.as<CycleReport>().steps);
    return outcome;
  }
  // The same findings, in the words of this block.
  const ErrorEntry* entry = findError(kBlock<PickAndPlaceGoal>, outcome.error_id);
  assert(entry != nullptr);
  const bool is_general = outcome.remedy == findError(kBlock<CheckSequenceGoal>, outcome.error_id)->remedy;
  if (is_general) outcome.remedy = entry->remedy;
  return outcome;
}

std::unique_ptr<Run> runOf(const PickAndPlaceGoal& goal, GoalId id, const Outcome& planned, Instant now) {
  return std::make_unique<PickAndPlaceRun>(id, goal, planned.detail.as<CycleReport>().steps, now);
}

}  // namespace cobot_command::blocks
