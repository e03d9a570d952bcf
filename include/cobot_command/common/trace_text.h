// The flight recorder's text of a frame, as FrameTrace.msg says: all of any usual script.
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
