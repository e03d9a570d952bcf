// What this process has allocated at the moment [bytes], by the account of its allocator. Nothing under a
// sanitizer, which brings its own.
#pragma once

#include <optional>

#include <malloc.h>

namespace cobot_command::testing {

inline std::optional<std::size_t> allocatedBytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return std::nullopt;
#else
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

}  // namespace cobot_command::testing
