// Prints a source in canonical form: two blanks for each level, one instruction on a line, reserved words in
// capitals, each name as it is declared. Tokens and comments do not change; blank lines are reduced to one.
// To print the result again changes nothing.
#pragma once

#include <string>

#include "cobot_command/rapid/source/predefined_names.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::rapid {

/// In UTF-8, with the line ends of the source; encoded() makes the bytes of a file of it. Precondition: the
/// source is not broken. Names that neither the source declares nor `predefined` has stay as they are.
[[nodiscard]] std::string print(const Source& source, const PredefinedNames& predefined);

}  // namespace cobot_command::rapid
