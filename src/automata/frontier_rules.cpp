#include "cobot_command/automata/frontier_rules.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::automata {
namespace {

using Automata = std::vector<std::size_t>;  // ascending

/// All states that are reached where nothing controllable leads into the frontier.
std::optional<PackedStates> reachedUnder(const CompiledSupervisor& supervisor, const Composition& composition,
                                         std::size_t max_states) {
  PackedStates frontier(composition);
  for (const Tuple& tuple : supervisor.frontier) frontier.insert(tuple.data());
  PackedStates reached(composition);
  reached.insert(composition.initial().data());
  Tuple from = composition.initial();
  Tuple to = from;
  for (PackedStates::Number number = 0; number < reached.size(); ++number) {
    if (reached.size() > max_states) return std::nullopt;
    reached.unpack(number, from.data());
    composition.forEachCandidate(from.data(), [&](EventIndex event) {
      if (composition.step(from.data(), event, to.data()) != Composition::Step::Possible) return;
      if (composition.isControllable(event) && frontier.find(to.data())) return;
      reached.insert(to.data());
    });
  }
  return reached;
}

/// A few automata of which each set has at least one: the fewest, found by trying one more until it does.
class HittingSet {
 public:
  explicit HittingSet(const std::set<Automata>& sets) : sets_(sets.begin(), sets.end()) {
    // Small sets leave the fewest choices.
    std::stable_sort(sets_.begin(), sets_.end(),
                     [](const Automata& one, const Automata& other) { return one.size() < other.size(); });
    while (!extend(size_)) ++size_;
    std::sort(chosen_.begin(), chosen_.end());
  }
  [[nodiscard]] const Automata& chosen() const { return chosen_; }

 private:
  bool extend(std::size_t left) {
    const auto missed = std::find_if(sets_.begin(), sets_.end(), [&](const Automata& set) {
      return std::none_of(chosen_.begin(), chosen_.end(), [&](std::size_t automaton) {
        return std::binary_search(set.begin(), set.end(), automaton);
      });
    });
    if (missed == sets_.end()) return true;
    if (left == 0) return false;
    for (const std::size_t automaton : *missed) {
      chosen_.push_back(automaton);
      if (extend(left - 1)) return true;
      chosen_.pop_back();
    }
    return false;
  }

  std::vector<Automata> sets_;
  Automata chosen_;
  std::size_t size_ = 0;
};

class Reduction {
 public:
  Reduction(const CompiledSupervisor& supervisor, const PackedStates& reached)
      : supervisor_(supervisor), reached_(reached) {
    const auto& automata = supervisor.problem.automata;
    for (std::size_t index = 0; index < automata.size(); ++index) {
      if (automata[index].kind == Automaton::Kind::Plant) plants_.push_back(index);
    }
    all_.resize(automata.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
  }

  std::vector<FrontierRule> rules() {
    for (const Tuple& tuple : supervisor_.frontier) {
      if (!isCovered(tuple)) rules_.push_back(ruleFor(tuple));
    }
    while (mergeTwo()) {
    }
    dropNeedless();
    return std::move(rules_);
  }

 private:
  [[nodiscard]] bool isCovered(const Tuple& tuple) const {
    return std::any_of(rules_.begin(), rules_.end(),
                       [&](const FrontierRule& rule) { return rule.matches(tuple); });
  }

  [[nodiscard]] FrontierRule ruleFor(const Tuple& tuple) const {
    auto differences = differencesTo(tuple, plants_);
    // Plants alone do not tell it from something that may happen: the specs have to.
    if (differences.count(Automata()) != 0) differences = differencesTo(tuple, all_);
    differences.erase(Automata());
    const HittingSet fewest(differences);
    FrontierRule rule;
    for (const std::size_t automaton : fewest.chosen()) {
      rule.conditions.push_back({automaton, {tuple[automaton]}});
    }
    return rule;
  }

  /// In which of `automata` a reached state differs from the tuple; of each, once.
  [[nodiscard]] std::set<Automata> differencesTo(const Tuple& tuple, const Automata& automata) const {
    std::set<Automata> differences;
    Tuple state(tuple.size());
    Automata difference;
    for (PackedStates::Number number = 0; number < reached_.size(); ++number) {
      reached_.unpack(number, state.data());
      difference.clear();
      std::copy_if(automata.begin(), automata.end(), std::back_inserter(difference),
                   [&](std::size_t automaton) { return state[automaton] != tuple[automaton]; });
      differences.insert(difference);
    }
    return differences;
  }

  /// Two rules that differ in the states of one automaton alone match together what their union matches, and
  /// nothing else.
  bool mergeTwo() {
    for (std::size_t one = 0; one < rules_.size(); ++one) {
      for (std::size_t other = one + 1; other < rules_.size(); ++other) {
        const auto differing = onlyDifference(rules_[one], rules_[other]);
        if (!differing) continue;
        auto& states = rules_[one].conditions[*differing].states;
        const auto& more = rules_[other].conditions[*differing].states;
        std::vector<StateIndex> both;
        std::set_union(states.begin(), states.end(), more.begin(), more.end(), std::back_inserter(both));
        states = std::move(both);
        rules_.erase(rules_.begin() + static_cast<std::ptrdiff_t>(other));
        return true;
      }
    }
    return false;
  }

  static std::optional<std::size_t> onlyDifference(const FrontierRule& one, const FrontierRule& other) {
    if (one.conditions.size() != other.conditions.size()) return std::nullopt;
    std::optional<std::size_t> found;
    for (std::size_t index = 0; index < one.conditions.size(); ++index) {
      if (one.conditions[index].automaton != other.conditions[index].automaton) return std::nullopt;
      if (one.conditions[index].states == other.conditions[index].states) continue;
      if (found) return std::nullopt;
      found = index;
    }
    return found;
  }

  /// The last ones first: they were made for fewer states.
  void dropNeedless() {
    std::vector<std::size_t> count(supervisor_.frontier.size(), 0);
    const auto count_by = [&](const FrontierRule& rule, std::size_t by) {
      for (std::size_t index = 0; index < count.size(); ++index) {
        if (rule.matches(supervisor_.frontier[index])) count[index] += by;
      }
    };
    for (const FrontierRule& rule : rules_) count_by(rule, 1);
    for (std::size_t index = rules_.size(); index-- > 0;) {
      bool is_needed = false;
      for (std::size_t state = 0; state < count.size() && !is_needed; ++state) {
        is_needed = count[state] == 1 && rules_[index].matches(supervisor_.frontier[state]);
      }
      if (is_needed) continue;
      count_by(rules_[index], ~std::size_t{0});
      rules_.erase(rules_.begin() + static_cast<std::ptrdiff_t>(index));
    }
  }

  const CompiledSupervisor& supervisor_;
  const PackedStates& reached_;
  Automata plants_;
  Automata all_;
  std::vector<FrontierRule> rules_;
};

}  // namespace

bool FrontierRule::matches(const Tuple& tuple) const {
  return std::all_of(conditions.begin(), conditions.end(), [&](const RuleCondition& condition) {
    return std::binary_search(condition.states.begin(), condition.states.end(), tuple[condition.automaton]);
  });
}

Result<std::vector<FrontierRule>, TooManyStates> frontierRulesOf(const CompiledSupervisor& supervisor,
                                                                 std::size_t max_states) {
  const Composition composition(supervisor.problem);
  const auto reached = reachedUnder(supervisor, composition, max_states);
  if (!reached) return refuse(TooManyStates{max_states});
  return Reduction(supervisor, *reached).rules();
}

std::string toString(const FrontierRule& rule, const Problem& problem) {
  std::vector<std::string> words;
  for (const RuleCondition& condition : rule.conditions) {
    const Automaton& automaton = problem.automata[condition.automaton];
    std::vector<std::string> states;
    for (const StateIndex state : condition.states) states.push_back(automaton.states[state]);
    words.push_back(fmt::format("{} at {}", automaton.name, fmt::join(states, " or ")));
  }
  if (words.empty()) return "nothing";
  const std::string first = words.front();
  words.erase(words.begin());
  return words.empty() ? "not " + first : fmt::format("not {} while {}", first, fmt::join(words, " and "));
}

}  // namespace cobot_command::automata
