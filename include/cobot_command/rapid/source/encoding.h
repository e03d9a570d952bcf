// The bytes of a source file, and its text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobot_command::rapid {

enum class Encoding : std::uint8_t { Utf8, Utf8WithMark, Utf16Little, Utf16Big, Iso8859 };
/// The line ends that a text is written with: those of its first line.
enum class LineEnd : std::uint8_t { Lf, CrLf, Cr };

[[nodiscard]] std::string_view toString(LineEnd line_end);

/// The bytes of UTF-8 text in another encoding. A character that ISO 8859-1 does not have becomes `?`; a text
/// that was read as ISO 8859-1 has none.
[[nodiscard]] std::string encoded(std::string_view text, Encoding encoding);

}  // namespace cobot_command::rapid
