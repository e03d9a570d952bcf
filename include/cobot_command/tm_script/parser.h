// Parses the text of a script into a tree. Any text is accepted: a line that is not a statement becomes a
// fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// An error or a warning of a line.
struct Fault {
  int line = 0;  ///< from 1
  std::string reason;
};

/// The reason is treated as foreign text, because it may quote the script, and is at most a few lines long.
[[nodiscard]] Fault faultOf(int line, std::string_view reason);

struct ParsedScript {
  Script statements;          ///< of the lines without fault
  std::vector<Fault> faults;  ///< in the order of the lines, one per line
};

/// Lines end with LF or CR LF. `//` comments end with the line, `/* */` comments at their end mark. Nesting
/// deeper than kMaxNesting is a fault.
[[nodiscard]] ParsedScript parse(std::string_view text);

/// True for words with a meaning in scripts or in the programs of TMflow 2. They are not valid names of
/// variables.
[[nodiscard]] bool isReservedWord(std::string_view word);

}  // namespace cobot_command::tm_script
