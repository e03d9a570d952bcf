#include "search_states.h"

#include <utility>

namespace cobot_command::cell {

std::size_t SearchStates::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 14695981039346656037U;
  for (const std::uint32_t part : key) hash = (hash ^ part) * 1099511628211U;
  return static_cast<std::size_t>(hash ^ (hash >> 32U));
}

SearchStates::SearchStates(const Workload& work, Rule rule, const automata::Tuple& initial)
    : work_(work), rule_(std::move(rule)), robots_(work.robots.size()), automata_(initial.size()) {
  Key key(robots_, 0);
  key.insert(key.end(), initial.begin(), initial.end());
  numberOf(key);
}

SearchStates::Number SearchStates::numberOf(const Key& key) {
  const auto [at, is_new] = numbers_.emplace(key, size());
  if (is_new) {
    keys_.insert(keys_.end(), key.begin(), key.end());
    behind_.insert(behind_.end(), robots_, kUnknown);
  }
  return at->second;
}

std::optional<SearchStates::Number> SearchStates::behind(Number state, std::size_t robot) {
  const std::size_t slot = state * robots_ + robot;
  if (behind_[slot] == kUnknown) {
    const std::uint32_t* from = counts(state);
    const automata::Tuple tuple(from + robots_, from + robots_ + automata_);
    const automata::Decision decision = rule_(tuple, work_.robots[robot].events[from[robot]]);
    Number to = kRefused;
    if (decision.verdict == automata::Decision::Verdict::Granted) {
      Key key(from, from + robots_);
      ++key[robot];
      key.insert(key.end(), decision.next.begin(), decision.next.end());
      to = numberOf(key);
    }
    behind_[slot] = to;
  }
  if (behind_[slot] == kRefused) return std::nullopt;
  return behind_[slot];
}

}  // namespace cobot_command::cell
