// Explains the states that a supervisor avoids, as rules over few automata (doc/cell.md).
//
// "Not RA at its third place while RB is at its third" shows what a list of complete tuples hides. Together
// with the specs the rules refuse exactly what the frontier refuses: the closed loop is the same.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/state_space.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/common/result.h"

namespace cobot_command::automata {

struct RuleCondition {
  std::size_t automaton = 0;
  std::vector<StateIndex> states;  ///< ascending; the automaton is in one of them
};

/// A controllable event must not lead to a state in which all conditions hold.
struct FrontierRule {
  std::vector<RuleCondition> conditions;  ///< ascending by automaton

  [[nodiscard]] bool matches(const Tuple& tuple) const;
};

/// For each state of the frontier: the fewest automata that distinguish it from all states that the
/// supervisor permits; only plants if these are sufficient. Rules that differ in one automaton are merged,
/// and redundant rules are removed. The same supervisor gives the same rules. Precondition: verify() finds no
/// fault in it.
[[nodiscard]] Result<std::vector<FrontierRule>, TooManyStates> frontierRulesOf(
    const CompiledSupervisor& supervisor, std::size_t max_states);

struct RuleComparison {
  /// Sentences with the events that lead there: an event that a rule refuses and the frontier does not, or
  /// vice versa.
  std::vector<std::string> faults;
  std::size_t states = 0;   ///< reached under the supervisor; the rules were evaluated in each
  std::size_t refused = 0;  ///< pairs of a state and an event that both refuse
};

/// Compares both for each event in each state that is reached under the supervisor. If they always agree,
/// they reach the same states. Shares no code with the computation of the rules.
[[nodiscard]] RuleComparison compareRules(const CompiledSupervisor& supervisor,
                                          const std::vector<FrontierRule>& rules, std::size_t max_states);

/// "not RA at RA.2 while RB at RB.2 or RB.3".
[[nodiscard]] std::string toString(const FrontierRule& rule, const Problem& problem);

}  // namespace cobot_command::automata
