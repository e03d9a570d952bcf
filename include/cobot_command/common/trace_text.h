// Text of a frame for the flight recorder (FrameTrace.msg). The limit covers every usual script completely.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command {

inline constexpr std::size_t kTraceTextLimit = 4096;  // [bytes]

[[nodiscard]] inline std::string traceText(std::string_view bytes) {
  return foreignText(bytes, kTraceTextLimit);
}

}  // namespace cobot_command
