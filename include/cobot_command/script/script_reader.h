// What a script means for the robot before it is sent: it is read, checked and run as the controller would do
// it, with a robot that answers every command at once and writes it down.
//
// So variables, expressions, conversions, comments and conditions are those of the language. What only the
// robot knows - its attributes, variables and names of the project, what an earlier script has declared - is
// not known here, and a script that asks for it has no meaning yet.
#pragma once

#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/parser.h"

namespace cobot_command::script {

struct ReadCommand {
  int line = 1;  ///< from 1, empty lines count
  ScriptCommand command;
};

/// The commands in the order in which the controller executes them, up to its ScriptExit(). As the newest
/// TMflow reads it, with a licence for velocities; warnings (a real that becomes an integer) are none.
/// WaitQueueTag() answers that the tag is complete; analog outputs and ListenSend() are no commands.
///
/// Faults: at least one, in the order of the lines. Nothing of a script with one would be executed, or it
/// ends at that line, or its value is not known here.
[[nodiscard]] Result<std::vector<ReadCommand>, std::vector<tm_script::Fault>> readScript(
    std::string_view text);

}  // namespace cobot_command::script
