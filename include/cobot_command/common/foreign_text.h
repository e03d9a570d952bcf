// Escapes and bounds text from outside (a peer, a file, a goal, an operator) before it enters a result, a
// status, a log or a trace. The output is bounded, is UTF-8 and has no invisible characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cobot_command {

/// Longer than every known name, message or error text of a controller.
inline constexpr std::size_t kForeignTextLimit = 256;  // [bytes]
/// Limit of a quotation in an error text.
inline constexpr std::size_t kQuoteLimit = 64;  // [bytes]

/// Length of the "..." after a truncated text [bytes].
inline constexpr std::size_t kCutMark = 3;

/// The escaped text. If it exceeds `limit` bytes it is truncated and "..." is appended.
[[nodiscard]] std::string foreignText(std::string_view bytes, std::size_t limit = kForeignTextLimit);

/// The whole text, for a reader who needs every byte. Control characters, bytes that are not UTF-8, and
/// invisible Unicode characters that control a terminal or a line are written as \r, \n, \t, \xNN. At most
/// four times as long as the input.
[[nodiscard]] std::string escaped(std::string_view bytes);

/// Escapes a whole line of a log, error, answer or message before output, including foreign text that did not
/// pass through foreignText(). Not bounded. Every text output uses it: the message boards of the core, the
/// log of the simulated controller, the output of nodes and programs (test/checks/check_texts.py).
[[nodiscard]] std::string forPeople(std::string text);

[[nodiscard]] bool isUtf8(std::string_view bytes);
/// ASCII control characters.
[[nodiscard]] constexpr bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace cobot_command
