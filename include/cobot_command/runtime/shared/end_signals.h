// The signals that ask a program to come to its end.
#pragma once

#include <vector>

namespace cobot_command::runtime {

/// SIGINT (Ctrl-C), SIGTERM (systemd, docker), and SIGHUP (a closed terminal) unless it is ignored: then the
/// program was started by nohup, and shall outlive its terminal.
[[nodiscard]] std::vector<int> endSignals();

}  // namespace cobot_command::runtime
