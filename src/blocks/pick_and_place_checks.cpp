// What is wrong with a pick-and-place goal before anything is planned.

#include <algorithm>
#include <utility>

#include "block_rules.h"
#include "command_order.h"
#include "pick_and_place_run.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"
#include "cobot_command/blocks/goal_limits.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {
namespace {

constexpr int kMaxCycles = 1000000;
constexpr double kMaxDwell = 3600;

bool isOutput(const OutputAction& output) {
  const auto module = script::ioModule(output.module);
  return module && output.output >= 0 && output.output < script::ioCount(*module);
}

/// What is wrong with a step besides its move.
Failure blame(int error_id, std::string found, std::size_t index) {
  return {error_id, std::move(found), "", {static_cast<int>(index), 0, ""}};
}

void checkStep(const PickAndPlaceGoal& goal, std::size_t index, std::vector<Failure>& failures) {
  const PickAndPlaceStep& step = goal.steps[index];
  const std::size_t number = index + 1;
  if (const auto own = check(step.move); !own.empty()) {
    failures.push_back(stepRefused(index, goal.steps.size(), toRejection(Block::MoveAbsolute, own)));
  }
  if (!(step.dwell >= 0 && step.dwell <= kMaxDwell)) {
    failures.push_back(blame(own_error::kDwellRange,
                             fmt::format("the dwell of step {} is {} s", number, step.dwell), index));
  }
  if (step.output && !isOutput(*step.output)) {
    failures.push_back(blame(own_error::kOutputInvalid,
                             fmt::format("step {}: output {} of module '{}'", number, step.output->output,
                                         foreignText(step.output->module, kQuoteLimit)),
                             index));
  }
  if (step.move.blending_enable && (step.dwell > 0 || step.output)) {
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
    } else if (goal.steps[i].output) {
      failures.push_back(
          blame(own_error::kExitBeforeEnd, fmt::format("step {} has an output behind it", i + 1), i));
    } else {
      continue;
    }
    return;
  }
}

}  // namespace

std::vector<Failure> checkPickAndPlace(const PickAndPlaceGoal& goal) {
  std::vector<Failure> failures;
  if (!goal.steps_fault.empty()) {
    failures.push_back({own_error::kStepsUnreadable, goal.steps_fault, ""});
  } else if (goal.steps.empty() || goal.steps.size() > kMostCycleSteps) {
    failures.push_back({own_error::kStepCount, foundSteps(goal.steps.size(), kMostCycleSteps), ""});
  }
  if (goal.cycles < 0 || goal.cycles > kMaxCycles) {
    failures.push_back({own_error::kCycleRange, fmt::format("cycles is {}", goal.cycles), ""});
  }
  if (goal.buffer_mode < static_cast<int>(BufferMode::Refuse) ||
      goal.buffer_mode > static_cast<int>(BufferMode::Aborting)) {
    failures.push_back(
        {own_error::kBufferModeUnknown, fmt::format("buffer_mode is {}", goal.buffer_mode), ""});
  }
  for (std::size_t i = 0; i < goal.steps.size() && failures.empty(); ++i) {
    checkStep(goal, i, failures);
  }
  checkExits(goal, failures);
  return failures;
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

CheckSequenceGoal asSequence(const PickAndPlaceGoal& goal) {
  CheckSequenceGoal sequence;
  for (const PickAndPlaceStep& step : goal.steps) sequence.steps.emplace_back(step.move);
  sequence.comes_round = goal.cycles != 1;
  return sequence;
}

}  // namespace cobot_command::blocks
