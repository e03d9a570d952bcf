// The text of a script as a tree. Any text is fine: what is no statement becomes a fault of its line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// What is wrong, or suspicious, with a line.
struct Fault {
  int line = 0;  ///< from 1
  std::string reason;
};

/// What the script itself has in the reason comes out as foreign text, and no reason is longer than a few
/// lines.
[[nodiscard]] Fault faultOf(int line, std::string_view reason);

struct ParsedScript {
  Script statements;          ///< of the lines without fault
  std::vector<Fault> faults;  ///< in the order of the lines, one for each
};

/// Lines end with LF or CR LF. `//` comments end with the line, `/* */` comments where they say. Nesting
/// deeper than kMaxNesting is a fault.
[[nodiscard]] ParsedScript parse(std::string_view text);

/// Means something by itself, in scripts or in the programs of TMflow 2: no name for a variable.
[[nodiscard]] bool isReservedWord(std::string_view word);

}  // namespace cobot_command::tm_script
