// Converts problems to and from the text formats of other programs (doc/cell.md).
//
// A name that a format does not allow is replaced by a unique valid name. A comment of the file has the table
// of both names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/common/result.h"

namespace cobot_command::automata {

/// The JSON format of this package: {"format": "cobot-automata", "version": 1, "problems": [...]}, each with
/// `events`, `automata` and, for readers, `name` and `about`. Other keys are ignored. A fault is a sentence
/// with its position.
[[nodiscard]] Result<std::vector<Problem>, std::string> problemsFromJson(std::string_view text);
[[nodiscard]] std::string toJson(const std::vector<Problem>& problems);

/// Modules of Supremica and WATERS, plain automata. Refused, with the name: variables, guards, instances,
/// loops, events with an index. If no event list of an automaton has `:accepting`, all its states are marked,
/// as in these programs.
[[nodiscard]] Result<Problem, std::string> problemFromWmod(std::string_view text);
[[nodiscard]] std::string toWmod(const Problem& problem);

/// Eclipse ESCET, CIF 3.
[[nodiscard]] std::string toCif(const Problem& problem);

/// Graphviz: one digraph per automaton.
[[nodiscard]] std::string toDot(const Problem& problem);

}  // namespace cobot_command::automata
