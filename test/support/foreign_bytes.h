// Texts as hostile or broken peers, files and people send them, and what may be left of them on a screen.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace cobot_command::test_support {

/// Each byte between two letters, so that it is neither the first nor the last of the text: 256 texts.
inline std::vector<std::string> eachByte() {
  std::vector<std::string> texts;
  for (int byte = 0; byte < 256; ++byte) texts.push_back(std::string("A") + static_cast<char>(byte) + "B");
  return texts;
}

/// All bytes in one text.
inline std::string allBytes() {
  std::string text;
  for (int byte = 0; byte < 256; ++byte) text += static_cast<char>(byte);
  return text;
}

/// eachByte(), allBytes(), what steers a terminal or a line, and what is no UTF-8.
inline std::vector<std::string> foreignTexts() {
  std::vector<std::string> texts = eachByte();
  texts.push_back(allBytes());
  for (const char* text : {"A\x1B[31mB",
                           "A\x1B]0;title\x07"
                           "B",
                           "A\u009B31mB", "A\u202EB", "A\u2028B", "A\u200BB", "A\uFEFFB", "A\u00ADB",
                           "A\u2063B", "A\U000E0041B", "A\xC0\xAF",
                           "A\xED\xA0\x80"
                           "B",
                           "A\xF4\x90\x80\x80", "A\xE9\x81", "\x1B"}) {
    texts.emplace_back(text);
  }
  return texts;
}

/// The characters of a text that is UTF-8; an own decoder, so that it is not the tested one that says so.
/// Empty where it is none.
inline std::vector<char32_t> charactersOf(std::string_view text) {
  std::vector<char32_t> characters;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    const std::size_t size = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (size == 0 || at + size > text.size()) return {};
    char32_t character = size == 1 ? first : first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
      if ((byte(at + i) & 0xC0U) != 0x80) return {};
      character = (character << 6U) | (byte(at + i) & 0x3FU);
    }
    const char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (character < least[size] || character > 0x10FFFF || (character >= 0xD800 && character < 0xE000)) {
      return {};
    }
    characters.push_back(character);
    at += size;
  }
  return characters;
}

/// Steers the terminal, the line or the direction of writing, or is not to be seen.
inline bool isHarmful(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0xAD || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
         (c >= 0xE0000 && c <= 0xE007F);
}

/// One line of UTF-8 without anything that cannot be seen, of a length that a screen can show.
MATCHER(IsHarmless, "is one line of text that can be shown") {
  constexpr std::size_t kLongest = 8192;
  const std::string_view text = arg;
  if (text.size() > kLongest) {
    *result_listener << "has " << text.size() << " bytes";
    return false;
  }
  const std::vector<char32_t> characters = charactersOf(text);
  if (characters.empty() && !text.empty()) {
    *result_listener << "is no UTF-8";
    return false;
  }
  return std::none_of(characters.begin(), characters.end(), isHarmful);
}

}  // namespace cobot_command::test_support
