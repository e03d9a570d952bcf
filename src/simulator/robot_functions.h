// The robot's own functions: which forms of which function each version of TMflow has (fact sheet 2.2), and
// the command that a call of one means.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/protocol/script_command.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::simulator {

/// All of them, with ListenSend(), which is no command.
void declareRobotFunctions(tm_script::FunctionTable& functions);

/// What is wrong with a call, as far as its arguments are known: a data format that the function does not
/// take, a tag or mode that does not exist. Names of bases and TCPs are not looked at, nor is the licence.
[[nodiscard]] std::optional<std::string> objectionTo(
    const std::string& function, const std::vector<std::optional<tm_script::Scalar>>& arguments);

/// Precondition: a declared function other than ListenSend(), its arguments converted, and no objection to
/// them.
[[nodiscard]] protocol::ScriptCommand commandOf(const std::string& function,
                                                const tm_script::Arguments& arguments);

/// Does a call go into the queue of motions?
[[nodiscard]] bool isQueued(std::string_view function);
[[nodiscard]] bool isQueued(const protocol::ScriptCommand& command);
/// The functions of continuous velocities.
[[nodiscard]] bool needsLicence(std::string_view function);

}  // namespace cobot_command::simulator
