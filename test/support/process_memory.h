// What this process has allocated at the moment [bytes], by the account of its allocator. Nothing under a
// sanitizer, which brings its own.
#pragma once

#include <optional>

#include "watched.h"
#include <malloc.h>

namespace cobot_command::testing {

inline std::optional<std::size_t> allocatedBytes() {
  if (kIsWatched) return std::nullopt;
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace cobot_command::testing
