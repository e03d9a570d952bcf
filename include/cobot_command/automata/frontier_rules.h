// What a supervisor keeps out of, as rules over few automata: for people (cell.md, S4).
//
// "Not RA at its third place while RB is at its third" says what a list of whole tuples hides. Beside the
// specs such rules refuse exactly what the frontier refuses: the closed loop is the same.
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
  std::vector<StateIndex> states;  ///< ascending; it is in one of them
};

/// A controllable event must not lead to where all conditions hold.
struct FrontierRule {
  std::vector<RuleCondition> conditions;  ///< ascending by automaton

  [[nodiscard]] bool matches(const Tuple& tuple) const;
};

/// Of each state of the frontier the fewest automata that tell it from all that the supervisor lets happen,
/// plants alone where these do; rules that differ in one automaton become one, and none is there without
/// need. The same supervisor gives the same rules. Precondition: verify() finds nothing wrong with it.
[[nodiscard]] Result<std::vector<FrontierRule>, TooManyStates> frontierRulesOf(
    const CompiledSupervisor& supervisor, std::size_t max_states);

struct RuleComparison {
  /// Each a sentence with the events that lead there: what a rule refuses and the frontier does not, or the
  /// other way round.
  std::vector<std::string> faults;
  std::size_t states = 0;   ///< reached under the supervisor: the rules were asked in each
  std::size_t refused = 0;  ///< pairs of a state and an event that both refuse
};

/// Asks both about each event in each state that is reached under the supervisor; where they always agree,
/// they reach the same states. Shares no code with the reduction.
[[nodiscard]] RuleComparison compareRules(const CompiledSupervisor& supervisor,
                                          const std::vector<FrontierRule>& rules, std::size_t max_states);

/// "not RA at RA.2 while RB at RB.2 or RB.3".
[[nodiscard]] std::string toString(const FrontierRule& rule, const Problem& problem);

}  // namespace cobot_command::automata
