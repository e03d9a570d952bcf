// Where a number ends, and whether it is one.
#pragma once

#include <string_view>

#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::rapid {

struct NumberScan {
  std::size_t size = 0;       ///< [bytes]; with letters, digits and points that are glued to it
  bool is_number = false;     ///< otherwise E106
  bool can_overflow = false;  ///< so long, or with such an exponent, that its value must be checked
};

/// Precondition: `text` begins with a digit, or with a point and a digit.
[[nodiscard]] NumberScan scanNumber(std::string_view text, Dialect dialect);

}  // namespace cobot_command::rapid
