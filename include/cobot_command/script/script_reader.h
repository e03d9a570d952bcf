// Determines the robot commands of a script before it is sent. The script is parsed, checked and run as on
// the controller, with a robot that answers every command immediately and records it.
//
// Variables, expressions, conversions, comments and conditions therefore behave as in the language. Values
// that exist only on the robot are not available here: its attributes, the variables and names of the
// project, declarations of an earlier script. A script that needs them is refused.
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

/// The commands in the order in which the controller executes them, up to its ScriptExit(). Reads as the
/// newest TMflow with a licence for velocities. Warnings (a real number that becomes an integer) are no
/// faults. WaitQueueTag() returns that the tag is complete. ListenSend() is not a command.
///
/// Faults: at least one, in the order of the lines. Either the controller would execute nothing of the
/// script, or the script ends at that line, or a value is not known here.
[[nodiscard]] Result<std::vector<ReadCommand>, std::vector<tm_script::Fault>> readScript(
    std::string_view text);

}  // namespace cobot_command::script
