// Where a text ends, and what is wrong in it.
#pragma once

#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/finding.h"

namespace cobot_command::rapid {

struct TextScan {
  std::size_t size = 0;         ///< with its quotes [bytes]
  std::size_t characters = 0;   ///< of its value
  bool is_closed = false;       ///< otherwise E103; it ends with its line then
  std::vector<Span> bad_codes;  ///< E105: from the backslash, relative to the opening quote
};

/// Precondition: `text` begins with a quote.
[[nodiscard]] TextScan scanText(std::string_view text);

}  // namespace cobot_command::rapid
