// The lines of a script, its comments taken out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::language {

struct SourceLine {
  int number = 0;    ///< from 1
  std::string text;  ///< a comment is one blank; a text in quotes is left alone and ends with its line
};

/// All lines, also the empty ones. A comment that is not closed takes everything behind it.
[[nodiscard]] std::vector<SourceLine> splitLines(std::string_view script);

}  // namespace cobot_command::language
