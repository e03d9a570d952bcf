// Text from outside on its way to people: what a peer, a file, a goal or an operator says goes through here
// before it reaches a result, a status, a log or a trace. What comes out is bounded, UTF-8, and has no
// characters that are not to be seen.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cobot_command {

/// Longer than any name, message or error text of a controller that is known.
inline constexpr std::size_t kForeignTextLimit = 256;  // [bytes]
/// What an error quotes of something that is wrong.
inline constexpr std::size_t kQuoteLimit = 64;  // [bytes]

/// So many bytes "..." has, which stand behind a text that was cut.
inline constexpr std::size_t kCutMark = 3;

/// At most `limit` bytes of the text, escaped, and "..." when that is not all.
[[nodiscard]] std::string foreignText(std::string_view bytes, std::size_t limit = kForeignTextLimit);

/// All of it, for who wants to see every byte: control characters and bytes that are not UTF-8 shown as \r,
/// \n, \t, \xNN; also the characters of Unicode that steer a terminal or a line and cannot be seen. At most
/// four times as long.
[[nodiscard]] std::string escaped(std::string_view bytes);

/// A whole line of a log, error, answer or message on its way out: what is foreign in it does no harm, even
/// where it was not put in as foreignText(). Not bounded. Every sink of texts goes through it: the boards of
/// the core, the log of the simulated controller, what nodes and programs print (test/checks/check_texts.py).
[[nodiscard]] std::string forPeople(std::string text);

[[nodiscard]] bool isUtf8(std::string_view bytes);
/// Of ASCII.
[[nodiscard]] constexpr bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace cobot_command
