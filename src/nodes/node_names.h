// The names that a node is started with: of the command line, as `name:=value`, and of the environment.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace cobot_command::nodes {

/// A variable of the environment, or nothing where it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// Why roscpp could not use one of them: it throws, or ends the process by a trap, for what is no name, no
/// port and no address of a master. A sentence of what was found, what is allowed and what to do; nothing
/// when all can be used. To be asked before ros::init().
[[nodiscard]] std::optional<std::string> faultInNames(int argc, const char* const* argv,
                                                      const Environment& environment);

[[nodiscard]] std::optional<std::string> ofProcess(const char* name);

}  // namespace cobot_command::nodes
