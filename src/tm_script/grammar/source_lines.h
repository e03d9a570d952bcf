// The lines of a script, its comments taken out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::tm_script {

struct SourceLine {
  int number = 0;    ///< from 1
  std::string text;  ///< a comment is one blank; a text in quotes is left alone and ends with its line
};

struct SourceLines {
  std::vector<SourceLine> lines;    ///< all, also the empty ones
  std::optional<int> open_comment;  ///< the line where a comment begins that is not closed
};

/// A comment that is not closed takes everything behind it.
[[nodiscard]] SourceLines splitLines(std::string_view script);

}  // namespace cobot_command::tm_script
