// Whether bytes are text. The controller's text is UTF-8 throughout (I848-E-03 section 7.3).
#pragma once

#include <string_view>

#include <boost/locale/utf.hpp>

namespace cobot_command::protocol {

/// Bytes of the character at the front; 0 when it is none. Precondition: bytes is not empty.
[[nodiscard]] inline std::size_t utf8Length(std::string_view bytes) {
  const char* next = bytes.data();
  const auto code_point = boost::locale::utf::utf_traits<char>::decode(next, bytes.data() + bytes.size());
  return boost::locale::utf::is_valid_codepoint(code_point) ? static_cast<std::size_t>(next - bytes.data())
                                                            : 0;
}

[[nodiscard]] inline bool isUtf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t size = utf8Length(bytes);
    if (size == 0) return false;
    bytes.remove_prefix(size);
  }
  return true;
}

}  // namespace cobot_command::protocol
