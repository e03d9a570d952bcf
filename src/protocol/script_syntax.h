// One line of script as syntax: Name(literal, ...) or IO[literal].Name[literal]=literal, not yet a command.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::protocol {

/// An argument as it is written.
struct Literal {
  enum class Kind {
    Integer,  ///< 35, 0x23, 0b100011
    Real,     ///< has a decimal point, or does not fit into 64 bits
    Boolean,  ///< true, True, false, False
    Text,     ///< "...", a doubled quote stands for one
    Array,    ///< {number, ...}
    Name      ///< a variable: the parser has none, it only gives a clear fault
  };
  Kind kind = Kind::Integer;
  double number = 0;  ///< of an Integer or Real
  bool flag = false;
  std::string text;  ///< of a Text or Name
  std::vector<Literal> elements;
};

struct Call {
  std::string function;
  std::vector<Literal> arguments;
};

/// IO["module"].DO[index]=value is a call of this, with the module, the attribute as a Name, the index and
/// the value as its arguments. No function can have such a name.
inline constexpr const char* kAssignOutput = "IO[]=";

/// Nothing for a line that is empty or only a // comment. The error tells the column and what was expected.
[[nodiscard]] Result<std::optional<Call>, std::string> parseLine(std::string_view line);

}  // namespace cobot_command::protocol
