// The operator's side as lines of text, for a terminal or a pipe: "pause", "speed 50", "fault drop_tag 1".
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/common/result.h"
#include "cobot_command/simulator/fault_switches.h"
#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::simulator {

/// Does what one line says. "help" and "faults" answer with several lines, all others with one; a line
/// without words is done with an empty text.
OperatorReply control(SimulatedController& controller, std::string_view line, Instant now);

/// What a text "drop_tag 1" orders: the name of a fault, how often, and what it needs; or what is wrong.
[[nodiscard]] Result<SetFault, std::string> parseFault(const std::string& text);

/// All commands, one a line.
[[nodiscard]] std::string controlHelp();

}  // namespace cobot_command::simulator
