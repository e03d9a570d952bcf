#include "cobot_command/common/foreign_text.h"

#include <algorithm>
#include <array>

#include <boost/locale/utf.hpp>

namespace cobot_command {
namespace {

using CodePoint = boost::locale::utf::code_point;

struct Character {
  std::size_t size = 1;  ///< [bytes]
  bool shown = false;    ///< as it is
};

struct CodePoints {
  CodePoint first;
  CodePoint last;
};
/// They move the cursor, the line or the direction of writing, or stand for nothing.
constexpr std::array<CodePoints, 12> kInvisible = {{{0x00, 0x1F},
                                                    {0x7F, 0x9F},
                                                    {0xAD, 0xAD},
                                                    {0x61C, 0x61C},
                                                    {0x180E, 0x180E},
                                                    {0x200B, 0x200F},
                                                    {0x2028, 0x202E},
                                                    {0x2060, 0x206F},
                                                    {0xFEFF, 0xFEFF},
                                                    {0xFFF9, 0xFFFB},
                                                    {0xFFFE, 0xFFFF},
                                                    {0xE0000, 0xE007F}}};

bool isInvisible(CodePoint c) {
  return std::any_of(kInvisible.begin(), kInvisible.end(),
                     [c](const CodePoints& range) { return c >= range.first && c <= range.last; });
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

std::string forPeople(std::string text) {
  const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 0x7F; });
  return is_plain ? text : escaped(text);
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
