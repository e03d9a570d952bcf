// The robot's own functions: which forms of which function each version of TMflow has (TM 2.2), and
// the command that a call of one means. One row for each in src/script/*_functions.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::script {

/// All of them, with ListenSend(), which is no command.
void declareRobotFunctions(tm_script::FunctionTable& functions);

/// The arguments of a call, as far as they are known. Arrays are not looked at.
using KnownArguments = std::vector<std::optional<tm_script::Scalar>>;
[[nodiscard]] KnownArguments knownArguments(const tm_script::Arguments& arguments);
/// What is wrong with a call, as far as its arguments are known: a data format that the function does not
/// take, a tag or mode that does not exist, a name that can be none. Whether the project has a base or TCP is
/// not looked at, nor is the licence.
[[nodiscard]] std::optional<std::string> objectionTo(const std::string& function,
                                                     const KnownArguments& arguments);

/// Precondition: a declared function other than ListenSend(), its arguments converted, and no objection to
/// them.
[[nodiscard]] ScriptCommand commandOf(const std::string& function, const tm_script::Arguments& arguments);

/// Does a call go into the queue of motions?
[[nodiscard]] bool isQueued(std::string_view function);
[[nodiscard]] bool isQueued(const ScriptCommand& command);
/// The functions of continuous velocities.
[[nodiscard]] bool needsLicence(std::string_view function);

}  // namespace cobot_command::script
