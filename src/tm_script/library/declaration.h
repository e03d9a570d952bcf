// Reads the declaration of a function; its form is told in functions.h.
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/tm_script/functions.h"

namespace cobot_command::tm_script {

/// Precondition: a declaration of that form.
[[nodiscard]] Function readDeclaration(std::string_view declaration);

/// As it is declared, for messages: "int, float[6]".
[[nodiscard]] std::string toText(const Function& function);

}  // namespace cobot_command::tm_script
