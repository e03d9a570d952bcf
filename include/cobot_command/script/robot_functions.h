// The robot's own functions: the signatures that each TMflow version has (TM 2.2), and the command of a call.
// src/script/*_functions.cpp has one row per function.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::script {

/// All of them, and ListenSend(), which is not a command.
void declareRobotFunctions(tm_script::FunctionTable& functions);

/// The arguments of a call that are known before it runs. Arrays are not inspected.
using KnownArguments = std::vector<std::optional<tm_script::Scalar>>;
[[nodiscard]] KnownArguments knownArguments(const tm_script::Arguments& arguments);
/// The error of a call as far as its arguments are known: a data format that the function does not accept, a
/// tag or mode that does not exist, an invalid name. It does not check whether the project has the base or
/// TCP, nor the licence.
[[nodiscard]] std::optional<std::string> objectionTo(const std::string& function,
                                                     const KnownArguments& arguments);

/// Precondition: a declared function other than ListenSend(), converted arguments, and no objection to them.
[[nodiscard]] ScriptCommand commandOf(const std::string& function, const tm_script::Arguments& arguments);

/// True if a call is added to the motion queue.
[[nodiscard]] bool isQueued(std::string_view function);
[[nodiscard]] bool isQueued(const ScriptCommand& command);
/// True for the functions of continuous velocities.
[[nodiscard]] bool needsLicence(std::string_view function);

}  // namespace cobot_command::script
