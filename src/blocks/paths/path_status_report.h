// What a chain tells everyone of how its path goes (PathStatus): what of it, and when.
#pragma once

#include <optional>

#include "chain/path_chain.h"
#include "paths/path_progress.h"

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// From its first motion on 20 times a second, until it is ended.
class PathStatusClock {
 public:
  /// Nothing new for one that has begun.
  void begin(Instant now);
  [[nodiscard]] std::optional<Instant> due() const { return due_; }
  /// True: it is due; then the next one is.
  [[nodiscard]] bool takeDue(Instant now);
  /// False: it had not begun.
  [[nodiscard]] bool end();

 private:
  std::optional<Instant> due_;
};

/// Of a chain that is under way, but for how it is controlled. `place`: what its goals were told last.
[[nodiscard]] PathStatus statusOf(const PathChain& chain, const PathChain::Place& place,
                                  const PathProgress& progress, Instant now);

}  // namespace cobot_command::blocks
