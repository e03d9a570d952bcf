// CBT_Connect (thesis 5.3.1): opens the link and supervises it. Busy while connected.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

struct ConnectGoal {
  static constexpr const char* kName = "connect";
  [[nodiscard]] static ErrorTable errors();

  std::string host;                ///< name or address of the controller
  int port = 5890;                 ///< script port, 0..65535; 0 is refused because no port has this number
  double timeout = 10;             ///< maximum time to try [s], 10..300
  std::optional<int> status_port;  ///< of the status stream, 0: none; nullopt: the port of LinkSettings
};

/// Detail of the outcome and of the progress: LastConnTime and LastLostTime since the goal was executed
/// (thesis 5.3.1.1); nullopt: not yet.
struct LinkTimes {
  std::optional<Instant> last_connected;
  std::optional<Instant> last_lost;
};

[[nodiscard]] GoalTraits traitsOf(const ConnectGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ConnectGoal& goal);

}  // namespace cobot_command::blocks
