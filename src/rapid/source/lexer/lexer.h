// From text to tokens.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/dialect.h"
#include "cobot_command/rapid/source/finding.h"
#include "cobot_command/rapid/source/name_table.h"
#include "cobot_command/rapid/source/token.h"

namespace cobot_command::rapid {

/// A line with a lexical error: no syntax error at or after it is reported on this line.
struct FaultyLine {
  std::uint32_t line = 0;         ///< index in Lexed::line_starts
  std::uint32_t first_error = 0;  ///< offset of its first lexical error
};

struct Lexed {
  std::vector<Token> tokens;
  std::vector<std::uint32_t> line_starts;  ///< offset of the first character of each line
  /// In the order of the text. Not complete after so many that no later finding is reported anyway.
  std::vector<FaultyLine> faulty_lines;
};

/// Reports E101 to E107. `text`: UTF-8 of less than 4 GiB.
[[nodiscard]] Lexed lex(std::string_view text, Dialect dialect, NameTable& names, Findings& findings);

/// Index of the line with the byte at `offset`.
[[nodiscard]] std::uint32_t lineAt(const std::vector<std::uint32_t>& line_starts, std::uint32_t offset);

}  // namespace cobot_command::rapid
