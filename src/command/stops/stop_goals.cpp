#include "stops/stop_goals.h"

#include <algorithm>
#include <utility>

namespace cobot_command::command {

void StopGoals::accept(blocks::GoalId goal) {
  board_.accept(kBlock, goal, 0);
  blocks::Progress progress;
  progress.phase = blocks::Phase::Stopping;
  progress.text = "stopping the robot";
  board_.progress(kBlock, goal, std::move(progress));
}

void StopGoals::wait(blocks::GoalId goal, StopRun::Number stop) {
  goals_.push_back({goal, stop});
}

std::vector<StopGoals::Goal>::const_iterator StopGoals::find(const StopRun::Result& result) const {
  return std::find_if(goals_.begin(), goals_.end(),
                      [&](const Goal& goal) { return goal.stop == result.number; });
}

bool StopGoals::asked(const StopRun::Result& result) const {
  return find(result) != goals_.end();
}

void StopGoals::ended(const StopRun::Result& result) {
  const auto goal = find(result);
  if (goal == goals_.end()) return;
  blocks::Outcome outcome;
  if (result.failed()) {
    outcome = blocks::toOutcome(kBlock, blocks::Ending::Aborted, result.failure);
  } else if (result.end != StopEnd::Stopped) {
    outcome.error_description = result.words();
  }
  board_.end(kBlock, goal->id, std::move(outcome));
  goals_.erase(goal);
}

void StopGoals::abort(const std::string& why) {
  for (const Goal& goal : std::exchange(goals_, {})) {
    board_.end(kBlock, goal.id, blocks::commandAborted(why));
  }
}

}  // namespace cobot_command::command
