// Operator commands as lines of text, for a terminal or a pipe: "pause", "speed 50", "fault drop_tag 1".
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/common/result.h"
#include "cobot_command/simulator/fault_switches.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::simulator {

/// Executes one line. "help" and "faults" answer with several lines, all others with one. An empty line is
/// accepted and answered with an empty text.
OperatorReply control(SimulatedController& controller, std::string_view line, Instant now);

/// Parses a text such as "drop_tag 1": the name of a fault, the count, and its value. The error describes
/// what is wrong.
[[nodiscard]] Result<SetFault, std::string> parseFault(const std::string& text);

/// All commands, one per line.
[[nodiscard]] std::string controlHelp();

}  // namespace cobot_command::simulator
