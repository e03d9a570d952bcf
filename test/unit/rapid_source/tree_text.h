// Trees as text, so that tests can compare them; and sources read from a few lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

/// "Sum(Number 1, Number 2)": kind, word or name where the kind has one, children.
[[nodiscard]] std::string treeText(const Source& source, NodeIndex node);

/// So often after each other.
[[nodiscard]] std::string repeated(std::size_t times, const std::string& text);
/// The lines in `PROC p()` of a module `m`, which begins with `declarations`, if there are any. The first one
/// is line 3 of the text.
[[nodiscard]] std::string inRoutine(const std::string& lines, const std::string& declarations = "");
/// The list of this routine.
[[nodiscard]] NodeIndex bodyOf(const Source& source);
/// The tree of the first instruction or declaration of such a routine.
[[nodiscard]] std::string instructionText(const std::string& line, Dialect dialect = Dialect::Irc5);
/// The tree of an expression: the value of an assignment.
[[nodiscard]] std::string expressionText(const std::string& expression);

/// "E201 3:5" of each finding.
[[nodiscard]] std::vector<std::string> idsAndPlaces(const Source& source);
[[nodiscard]] std::vector<std::string> findingsOf(const std::string& text, Dialect dialect = Dialect::Irc5);

/// The kinds and texts of all tokens; names and words in small letters.
[[nodiscard]] std::vector<std::string> tokenTexts(const Source& source);

}  // namespace cobot_command::rapid
