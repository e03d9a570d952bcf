// Texts by characters: what a script counts. A byte that belongs to no character of UTF-8 counts as one.
#pragma once

#include <string>
#include <string_view>

namespace cobot_command::tm_script {

[[nodiscard]] std::size_t characterCount(std::string_view text);
/// The byte at which a character starts; the end of the text when it has fewer.
[[nodiscard]] std::size_t byteOf(std::string_view text, std::size_t character);

/// From one found text to another, both with it.
struct Token {
  std::size_t first = 0;  ///< byte
  std::size_t size = 0;
};
/// The next part from `prefix` to `suffix`, at or after the byte `start`. An empty prefix is where the search
/// starts, an empty suffix is the end of the text.
[[nodiscard]] Token findToken(std::string_view text, std::string_view prefix, std::string_view suffix,
                              std::size_t start);
inline constexpr std::size_t kNotFound = std::string_view::npos;  ///< the `first` of no token

}  // namespace cobot_command::tm_script
