// Deadlines that may not be there.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command {

/// The one that comes first; nothing only when there is none.
[[nodiscard]] constexpr std::optional<Instant> earlier(const std::optional<Instant>& a,
                                                       const std::optional<Instant>& b) {
  if (!a) return b;
  return b && *b < *a ? b : a;
}

}  // namespace cobot_command
