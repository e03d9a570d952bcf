// The signals that request the end of a program.
#pragma once

#include <vector>

namespace cobot_command::runtime {

/// SIGINT (Ctrl-C), SIGTERM (systemd, docker), and SIGHUP (a closed terminal) unless it is ignored: then
/// nohup started the program, and it must continue after its terminal is closed.
[[nodiscard]] std::vector<int> endSignals();

}  // namespace cobot_command::runtime
