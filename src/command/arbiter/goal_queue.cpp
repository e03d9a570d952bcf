#include "arbiter/goal_queue.h"

#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

std::deque<Waiting>::iterator GoalQueue::at(blocks::GoalId id) {
  return std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& w) { return w.id == id; });
}

Waiting* GoalQueue::find(blocks::GoalId id) {
  const auto found = at(id);
  return found == waiting_.end() ? nullptr : &*found;
}

void GoalQueue::push(Waiting waiting) {
  board_.wait(blocks::blockOf(waiting.goal), waiting.id);
  waiting_.push_back(std::move(waiting));
}

Waiting GoalQueue::take() {
  Waiting first = std::move(waiting_.front());
  waiting_.pop_front();
  return first;
}

bool GoalQueue::drop(blocks::GoalId id, const std::string& why) {
  const auto found = at(id);
  if (found == waiting_.end()) return false;
  const blocks::Block block = blocks::blockOf(found->goal);
  waiting_.erase(found);
  forgetPlan(id);
  forgetForecasts();
  board_.end(block, id, blocks::commandAborted(why));
  return true;
}

void GoalQueue::dropAll(const std::string& why, blocks::GoalId newest) {
  if (newest > fell_.newest) {
    fell_ = {newest, why};
    actions_.emplace_back(fell_);
  }
  for (const Waiting& waiting : std::exchange(waiting_, {})) {
    forgetPlan(waiting.id);
    board_.end(blocks::blockOf(waiting.goal), waiting.id, blocks::commandAborted(why));
  }
}

/// A take-over is in front of all others, as it has dropped what waited.
void GoalQueue::dropUnstopped(const std::string& why) {
  std::optional<Waiting> take_over;
  if (!empty() && front().takes_over) take_over = take();
  dropAll(why);
  if (!take_over) return;
  const blocks::Block block = blocks::blockOf(take_over->goal);
  board_.end(block, take_over->id,
             blocks::toRejection(block, {{blocks::own_error::kStopNotConfirmed, why, ""}}));
}

std::optional<std::string> GoalQueue::fell(blocks::GoalId id, const blocks::Goal& goal) const {
  return id <= fell_.newest && fallsWithOthers(goal) ? std::make_optional(fell_.why) : std::nullopt;
}

void GoalQueue::forgetForecasts() {
  for (Waiting& waiting : waiting_) waiting.end.reset();
}

void GoalQueue::tellPlaces(const std::function<std::string(int place)>& text) {
  int place = 0;
  for (Waiting& waiting : waiting_) {
    ++place;
    if (waiting.told_place == place) continue;
    waiting.told_place = place;
    blocks::Progress progress;
    progress.phase = blocks::Phase::Queued;
    progress.place_in_queue = place;
    progress.text = text(place);
    board_.progress(blocks::blockOf(waiting.goal), waiting.id, std::move(progress));
  }
}

}  // namespace cobot_command::command
