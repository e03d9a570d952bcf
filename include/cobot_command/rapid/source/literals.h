// The values of literals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cobot_command::rapid {

/// The value of a number as it is written (`3E2`, `.5`, `0x1F`), rounded to single precision; std::nullopt if
/// it is beyond it (E107), or no number (E106). A number that is too small for single precision is 0.
[[nodiscard]] std::optional<float> numberValue(std::string_view written);

/// The value of a text as it is written, with its quotes: escapes are replaced. In UTF-8. A backslash that
/// begins no character code (E105) stands for itself.
[[nodiscard]] std::string textValue(std::string_view written);

}  // namespace cobot_command::rapid
