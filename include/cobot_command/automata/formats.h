// Problems as text of other programs, and back (cell.md, M27).
//
// Where a format does not allow a name, another one stands for it, a different one for each, and a comment of
// the file has the table of both.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/common/result.h"

namespace cobot_command::automata {

/// Our own: {"format": "cobot-automata", "version": 1, "problems": [...]}, each with `events`, `automata`
/// and, for people, `name` and `about`. What else stands in it is left to whoever has written it. A fault is
/// a sentence with the place.
[[nodiscard]] Result<std::vector<Problem>, std::string> problemsFromJson(std::string_view text);
[[nodiscard]] std::string toJson(const std::vector<Problem>& problems);

/// Modules of Supremica and WATERS, plain automata. Refused by name: variables, guards, instances, loops,
/// events with an index. An automaton in which no event list has `:accepting` is marked everywhere, as it is
/// for those.
[[nodiscard]] Result<Problem, std::string> problemFromWmod(std::string_view text);
[[nodiscard]] std::string toWmod(const Problem& problem);

/// Eclipse ESCET, CIF 3.
[[nodiscard]] std::string toCif(const Problem& problem);

/// Graphviz: a digraph of each automaton.
[[nodiscard]] std::string toDot(const Problem& problem);

}  // namespace cobot_command::automata
