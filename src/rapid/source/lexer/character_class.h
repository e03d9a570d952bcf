// What a byte of UTF-8 can be in a source text.
#pragma once

#include <array>
#include <cstdint>

namespace cobot_command::rapid {

enum class CharacterClass : std::uint8_t {
  Unknown,
  Blank,
  LineEnd,
  Letter,
  Digit,
  Underscore,
  Latin,  ///< the first byte of most letters of ISO 8859-1; the second one decides
  Quote,
  Comment,
  Dot,
  Sign,
};

namespace detail {

constexpr std::array<CharacterClass, 256> characterClasses() {
  std::array<CharacterClass, 256> classes{};
  const auto set = [&classes](const char* characters, CharacterClass the_class) {
    for (const char* c = characters; *c != '\0'; ++c) classes[static_cast<unsigned char>(*c)] = the_class;
  };
  set(" \t\f", CharacterClass::Blank);
  set("\r\n", CharacterClass::LineEnd);
  set("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz", CharacterClass::Letter);
  set("0123456789", CharacterClass::Digit);
  set("_", CharacterClass::Underscore);
  set("\xC3", CharacterClass::Latin);
  set("\"", CharacterClass::Quote);
  set("!", CharacterClass::Comment);
  set(".", CharacterClass::Dot);
  set(";:,=<>+-*/\\|?%()[]{}", CharacterClass::Sign);
  return classes;
}

inline constexpr std::array<CharacterClass, 256> kCharacterClasses = characterClasses();

}  // namespace detail

[[nodiscard]] constexpr CharacterClass classOf(char byte) {
  return detail::kCharacterClasses[static_cast<unsigned char>(byte)];
}

/// The second byte of a letter whose first one is CharacterClass::Latin; the signs of multiplication and
/// division are between the letters.
[[nodiscard]] constexpr bool isLatinLetter(char second) {
  const auto value = static_cast<unsigned char>(second);
  return value >= 0x80 && value <= 0xBF && value != 0x97 && value != 0xB7;
}

}  // namespace cobot_command::rapid
