// The two dialects of RAPID that are read: that of the IRC5 controller, and that of the older S4C controller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cobot_command::rapid {

enum class Dialect : std::uint8_t { Irc5, S4c };

/// "irc5", "s4c".
[[nodiscard]] std::string_view toString(Dialect dialect);
[[nodiscard]] std::optional<Dialect> dialectNamed(std::string_view name);

/// Letters that an identifier may have.
[[nodiscard]] constexpr std::size_t lettersAllowedBy(Dialect dialect) {
  return dialect == Dialect::S4c ? 16 : 32;
}

}  // namespace cobot_command::rapid
