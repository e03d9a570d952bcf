// Functions of the manuals that the simulation does not have.
#pragma once

#include <string>
#include <string_view>

namespace cobot_command::tm_script {

/// Why a name is not in the table of functions: known but not simulated, or unknown.
[[nodiscard]] std::string whyUnknown(std::string_view name);

}  // namespace cobot_command::tm_script
