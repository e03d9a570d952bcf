// Operations on optional deadlines.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command {

/// The earlier of two deadlines; std::nullopt only if both are missing.
[[nodiscard]] constexpr std::optional<Instant> earlier(const std::optional<Instant>& a,
                                                       const std::optional<Instant>& b) {
  if (!a) return b;
  return b && *b < *a ? b : a;
}

}  // namespace cobot_command
