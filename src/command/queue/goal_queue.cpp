#include "queue/goal_queue.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "exchange/motion_hold.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

std::deque<Waiting>::iterator GoalQueue::at(blocks::GoalId id) {
  return std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& w) { return w.id == id; });
}

int GoalQueue::motions() const {
  return std::accumulate(waiting_.begin(), waiting_.end(), 0,
                         [](int sum, const Waiting& waiting) { return sum + motionsOf(waiting.goal); });
}

Waiting* GoalQueue::find(blocks::GoalId id) {
  const auto found = at(id);
  return found == waiting_.end() ? nullptr : &*found;
}

const Waiting* GoalQueue::lastBefore(Ticket ticket) const {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [ticket](const Waiting& w) { return w.ticket < ticket; });
  return last == waiting_.rend() ? nullptr : &*last;
}

void GoalQueue::push(Waiting waiting) {
  waiting.ticket = last_ticket_;
  board_.wait(blocks::blockOf(waiting.goal), waiting.id);
  waiting_.push_back(std::move(waiting));
}

Waiting GoalQueue::take() {
  Waiting first = std::move(waiting_.front());
  waiting_.pop_front();
  return first;
}

Waiting GoalQueue::takeLast() {
  Waiting last = std::move(waiting_.back());
  waiting_.pop_back();
  return last;
}

std::deque<Waiting> GoalQueue::takeAll() {
  forgetTurn();
  forgetForecasts();
  for (const Waiting& waiting : waiting_) forgetPlan(waiting.id);
  return std::exchange(waiting_, {});
}

void GoalQueue::putBackAll(std::deque<Waiting> waiting) {
  waiting_.insert(waiting_.begin(), std::make_move_iterator(waiting.begin()),
                  std::make_move_iterator(waiting.end()));
  retell();
}

std::optional<Waiting> GoalQueue::takeFirstIf(bool (*is_meant)(const Waiting&)) {
  return !empty() && is_meant(front()) ? std::make_optional(take()) : std::nullopt;
}

void GoalQueue::forgetTurn() {
  if (!plansTheNext()) return;
  forgetPlan(front().id);
  front().found.reset();
  front().hold = nullptr;
  front().turn = Waiting::Turn::NotYet;
}

void GoalQueue::forgetWholePlan() {
  if (!empty() && front().turn == Waiting::Turn::PlansWhole) forgetTurn();
}

bool GoalQueue::drop(blocks::GoalId id, const std::string& why) {
  const auto found = at(id);
  if (found == waiting_.end()) return false;
  forgetForecasts();
  auto last = std::next(found);
  if (blocks::GoalRules(found->goal).traits().chains) {
    last = std::find_if(last, waiting_.end(),
                        [&](const Waiting& w) { return blockOf(w.goal) != blockOf(found->goal); });
  }
  const auto count = last - found;
  const std::string in_front = fmt::format("the {} before it was cancelled", toString(blockOf(found->goal)));
  for (auto i = count - 1; i >= 0; --i) {
    const auto waiting = at(id) + i;
    end(waiting, blocks::commandAborted(i == 0 ? why : in_front));
  }
  return true;
}

void GoalQueue::dropFirst(blocks::Block block, const std::string& why) {
  while (!empty() && blockOf(front().goal) == block) end(waiting_.begin(), blocks::commandAborted(why));
}

void GoalQueue::refuse(blocks::GoalId id, blocks::Outcome refusal) {
  end(at(id), std::move(refusal));
}

void GoalQueue::end(const std::deque<Waiting>::iterator& waiting, blocks::Outcome outcome) {
  const blocks::GoalId id = waiting->id;
  const blocks::Block block = blocks::blockOf(waiting->goal);
  waiting_.erase(waiting);
  forgetPlan(id);
  board_.end(block, id, std::move(outcome));
}

void GoalQueue::dropAll(const std::string& why, blocks::GoalId newest) {
  if (newest > fell_.newest) {
    fell_ = {newest, why};
    actions_.emplace_back(fell_);
  }
  const auto first_left = std::stable_partition(waiting_.begin(), waiting_.end(),
                                                [&](const Waiting& one) { return one.id <= newest; });
  std::deque<Waiting> dropped(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(first_left));
  waiting_.erase(waiting_.begin(), first_left);
  forgetForecasts();
  for (const Waiting& waiting : dropped) {
    forgetPlan(waiting.id);
    board_.end(blocks::blockOf(waiting.goal), waiting.id, blocks::commandAborted(why));
  }
}

int GoalQueue::dropBehindTurn(const std::string& why, blocks::GoalId newest) {
  auto turn = takeFirstIf([](const Waiting& first) { return first.turn == Waiting::Turn::PlansCommand; });
  const std::size_t others = size();
  dropAll(why, newest);
  const std::size_t dropped = others - size();
  if (turn) waiting_.push_front(*std::move(turn));
  return static_cast<int>(dropped);
}

/// A take-over is in front of all others, as it has dropped what waited.
void GoalQueue::dropUnstopped(const std::string& why) {
  const auto take_over = takeFirstIf([](const Waiting& first) { return first.takes_over; });
  dropAll(why);
  if (!take_over) return;
  const blocks::Block block = blocks::blockOf(take_over->goal);
  forgetPlan(take_over->id);
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
    const bool is_told = waiting.told_place == place && !retells_;
    if (is_told || waiting.turn == Waiting::Turn::PlansCommand) continue;
    waiting.told_place = place;
    blocks::Progress progress;
    progress.phase = blocks::Phase::Queued;
    progress.place_in_queue = place;
    progress.text = text(place);
    board_.progress(blocks::blockOf(waiting.goal), waiting.id, std::move(progress));
  }
  retells_ = false;
}

}  // namespace cobot_command::command
