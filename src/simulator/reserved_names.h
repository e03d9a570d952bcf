// Names that a variable of the project cannot have, as scripts would take it for something else.
#pragma once

#include <optional>
#include <string>

namespace cobot_command::simulator {

/// "a function", "a predefined item", ...; nothing when the name is free. In any version of TMflow.
[[nodiscard]] std::optional<std::string> whatIsNamed(const std::string& name);

}  // namespace cobot_command::simulator
