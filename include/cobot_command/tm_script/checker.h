// Checks a whole script before any of it is run, as the controller does.
//
// Errors: syntax, an unknown name or function, arguments or operands of a wrong type, a second declaration,
// an attribute that does not exist, an index outside an attribute of fixed length. Warnings: a real number
// that becomes an integer, an int that becomes a byte, a text that becomes a number or vice versa, a text
// without its double quotes, a variable in single quotes inside a text.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/tm_script/environment.h"
#include "cobot_command/tm_script/functions.h"
#include "cobot_command/tm_script/parser.h"
#include "cobot_command/tm_script/variables.h"

namespace cobot_command::tm_script {

struct Findings {
  std::vector<Fault> errors;    ///< in the order of the lines
  std::vector<Fault> warnings;  ///< in the order of the lines
};

/// Variables that the script declares are available from the next line. No variable is set.
[[nodiscard]] Findings check(const ParsedScript& script, const FunctionTable& functions, const Scope& scope,
                             const Environment& environment);

}  // namespace cobot_command::tm_script
