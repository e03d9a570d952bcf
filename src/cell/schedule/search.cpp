#include "search.h"

#include <algorithm>
#include <utility>

namespace cobot_command::cell {
namespace {

/// How often the search goes from its best entry straight home, for a schedule to be better than.
constexpr std::size_t kExpandedPerDive = 256;
/// How often whoever waits is asked.
constexpr std::size_t kExpandedPerQuestion = 64;

}  // namespace

/// Of those with the same bound the one that is nearest to the end, and of those the oldest.
bool Search::Open::operator<(const Open& other) const {
  if (bound != other.bound) return bound > other.bound;
  if (depth != other.depth) return depth < other.depth;
  return entry > other.entry;
}

Search::Search(const Workload& work, Rule rule, const automata::Tuple& initial)
    : work_(work), bound_(work), states_(work, std::move(rule), initial), robots_(work.robots.size()) {
  for (const auto& robot : work.robots) all_events_ += static_cast<std::uint32_t>(robot.size());
  const std::vector<Duration> times(robots_, Duration{});
  Entry start;
  start.bound = bound_.of(states_.counts(0), times.data(), Duration{});
  const Number entry = add(start, times);
  open_.push({start.bound, 0, entry});
}

Search::Number Search::add(const Entry& entry, const std::vector<Duration>& times) {
  entries_.push_back(entry);
  times_.insert(times_.end(), times.begin(), times.end());
  const auto number = static_cast<Number>(entries_.size() - 1);
  if (isComplete(number) && (best_ == kNone || makespanOf(number) < makespanOf(best_))) best_ = number;
  return number;
}

Duration Search::makespanOf(Number entry) const {
  return *std::max_element(times(entry), times(entry) + robots_);
}

bool Search::isWorthLookingAt(const Open& open) const {
  return !entries_[open.entry].is_dominated && (best_ == kNone || open.bound < makespanOf(best_));
}

/// Events happen one after the other, none later than a report that is due: so each entry has for each robot
/// at most one step. What may wait does so only because another event is chosen to be first.
void Search::findSteps(Number from) {
  steps_.clear();
  const SearchStates::Number state = entries_[from].state;
  const std::vector<Duration> before(times(from), times(from) + robots_);
  const Duration now = *std::max_element(before.begin(), before.end());
  const std::vector<std::uint32_t> counts(states_.counts(state), states_.counts(state) + robots_);
  std::vector<Duration> next(robots_, Duration::max());
  Duration due = Duration::max();
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    const Workload::Robot& cycle = work_.robots[robot];
    if (counts[robot] == cycle.size()) continue;
    next[robot] = std::max(before[robot] + cycle.after[counts[robot]], now);
    if (cycle.is_report[counts[robot]]) due = std::min(due, next[robot]);
  }
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    if (next[robot] == Duration::max() || next[robot] > due) continue;
    const auto to = states_.behind(state, robot);
    if (!to) continue;
    Step step{{*to, from, static_cast<std::uint32_t>(robot), entries_[from].depth + 1, false, {}}, before};
    step.times[robot] = next[robot];
    step.entry.bound =
        std::max(entries_[from].bound, bound_.of(states_.counts(*to), step.times.data(), next[robot]));
    if (best_ == kNone || step.entry.bound < makespanOf(best_)) steps_.push_back(std::move(step));
  }
}

/// Whether an entry of the same state is nowhere later; and marks those that are nowhere earlier than it.
bool Search::isDominated(const Entry& entry, const std::vector<Duration>& times_of_it) {
  if (entries_of_state_.size() <= entry.state) entries_of_state_.resize(states_.size());
  std::vector<Number>& others = entries_of_state_[entry.state];
  for (const Number other : others) {
    if (std::equal(times_of_it.begin(), times_of_it.end(), times(other),
                   [](Duration mine, Duration its) { return its <= mine; })) {
      return true;
    }
  }
  const auto is_later = [&](Number other) {
    return std::equal(times_of_it.begin(), times_of_it.end(), times(other),
                      [](Duration mine, Duration its) { return mine <= its; });
  };
  const auto worse =
      std::stable_partition(others.begin(), others.end(), [&](Number other) { return !is_later(other); });
  for (auto other = worse; other != others.end(); ++other) entries_[*other].is_dominated = true;
  others.erase(worse, others.end());
  return false;
}

void Search::expand(Number from) {
  ++expanded_;
  findSteps(from);
  for (const Step& step : steps_) {
    if (isDominated(step.entry, step.times)) continue;
    const Number entry = add(step.entry, step.times);
    entries_of_state_[step.entry.state].push_back(entry);
    if (!isComplete(entry)) open_.push({step.entry.bound, step.entry.depth, entry});
  }
}

/// Always the step with the least bound, and of those the earliest, as far as it goes. Its entries are not
/// searched from: they are there for the schedule that they may end in.
void Search::dive(Number from) {
  const auto is_before = [](const Step& one, const Step& other) {
    const Duration at = one.times[one.entry.robot];
    const Duration other_at = other.times[other.entry.robot];
    return std::make_pair(one.entry.bound, at) < std::make_pair(other.entry.bound, other_at);
  };
  while (!isComplete(from)) {
    findSteps(from);
    if (steps_.empty()) return;
    const Step& step = *std::min_element(steps_.begin(), steps_.end(), is_before);
    from = add(step.entry, step.times);
  }
}

void Search::run(const ScheduleLimits& limits) {
  dive(open_.top().entry);
  while (!open_.empty()) {
    const Open next = open_.top();
    if (!isWorthLookingAt(next)) {
      open_.pop();
      continue;
    }
    if (expanded_ >= limits.max_expanded) return;
    if (expanded_ % kExpandedPerQuestion == 0 && limits.is_over && limits.is_over()) return;
    open_.pop();
    if (expanded_ % kExpandedPerDive == kExpandedPerDive - 1) dive(next.entry);
    expand(next.entry);
  }
}

Duration Search::bound() const {
  if (!open_.empty()) return open_.top().bound;
  return best_ == kNone ? entries_.front().bound : makespanOf(best_);
}

std::vector<Move> Search::moves() const {
  std::vector<Move> moves;
  for (Number entry = best_; entries_[entry].parent != kNone; entry = entries_[entry].parent) {
    moves.push_back({entries_[entry].robot, times(entry)[entries_[entry].robot]});
  }
  std::reverse(moves.begin(), moves.end());
  return moves;
}

}  // namespace cobot_command::cell
