#include "cobot_command/common/foreign_text.h"

#include <algorithm>

#include <boost/locale/utf.hpp>

namespace cobot_command {
namespace {

using CodePoint = boost::locale::utf::code_point;

struct Character {
  std::size_t size = 1;  ///< [bytes]
  bool shown = false;    ///< as it is
};

/// Moves the cursor, the line or the direction of writing, or stands for nothing.
bool isInvisible(CodePoint c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029 || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

/// The character at the front. Precondition: bytes is not empty.
Character first(std::string_view bytes) {
  const char* next = bytes.data();
  const auto code_point = boost::locale::utf::utf_traits<char>::decode(next, bytes.data() + bytes.size());
  if (!boost::locale::utf::is_valid_codepoint(code_point)) return {};
  return {static_cast<std::size_t>(next - bytes.data()), !isInvisible(code_point)};
}

void appendEscaped(std::string& text, char byte) {
  constexpr std::string_view kHexDigits = "0123456789ABCDEF";
  switch (byte) {
    case '\r':
      text += "\\r";
      return;
    case '\n':
      text += "\\n";
      return;
    case '\t':
      text += "\\t";
      return;
    default: {
      const auto value = static_cast<unsigned char>(byte);
      text += {'\\', 'x', kHexDigits[value >> 4U], kHexDigits[value & 0x0FU]};
    }
  }
}

}  // namespace

std::string escaped(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const Character character = first(bytes);
    if (character.shown) {
      text.append(bytes.substr(0, character.size));
    } else {
      for (const char byte : bytes.substr(0, character.size)) appendEscaped(text, byte);
    }
    bytes.remove_prefix(character.size);
  }
  return text;
}

std::string foreignText(std::string_view bytes, std::size_t limit) {
  constexpr std::string_view kMore = "...";
  std::string text;
  while (!bytes.empty()) {
    const std::size_t size = first(bytes).size;
    const std::string shown = escaped(bytes.substr(0, size));
    if (text.size() + shown.size() > limit) return text.append(kMore);
    text += shown;
    bytes.remove_prefix(size);
  }
  return text;
}

bool isUtf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const char* next = bytes.data();
    const auto code_point = boost::locale::utf::utf_traits<char>::decode(next, bytes.data() + bytes.size());
    if (!boost::locale::utf::is_valid_codepoint(code_point)) return false;
    bytes.remove_prefix(static_cast<std::size_t>(next - bytes.data()));
  }
  return true;
}

}  // namespace cobot_command
