#include "cobot_command/runtime/shared/end_signals.h"

#include <csignal>

namespace cobot_command::runtime {

std::vector<int> endSignals() {
  struct sigaction hang_up {};
  const bool ignored = sigaction(SIGHUP, nullptr, &hang_up) == 0 && hang_up.sa_handler == SIG_IGN;
  return ignored ? std::vector<int>{SIGINT, SIGTERM} : std::vector<int>{SIGINT, SIGTERM, SIGHUP};
}

}  // namespace cobot_command::runtime
