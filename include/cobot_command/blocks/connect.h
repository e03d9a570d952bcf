// CBT_Connect (thesis 5.3.1): open the link and supervise it. Busy while connected.
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
  int port = 5890;                 ///< script port, 0..65535; 0 is refused as nothing can listen there
  double timeout = 10;             ///< how long to try [s], 10..300
  std::optional<int> status_port;  ///< of the status stream, 0: none; absent: the port of LinkSettings
};

/// Detail of its end and its progress: LastConnTime and LastLostTime, since it was executed (thesis 5.3.1.1);
/// absent: not yet.
struct LinkTimes {
  std::optional<Instant> last_connected;
  std::optional<Instant> last_lost;
};

[[nodiscard]] GoalTraits traitsOf(const ConnectGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ConnectGoal& goal);

}  // namespace cobot_command::blocks
