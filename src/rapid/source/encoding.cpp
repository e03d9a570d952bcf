#include "cobot_command/rapid/source/encoding.h"

#include <iterator>

#include <boost/locale/utf.hpp>

namespace cobot_command::rapid {

namespace {

namespace utf = boost::locale::utf;

void appendUnit(std::string& bytes, char16_t unit, bool is_little) {
  const auto low = static_cast<char>(unit & 0xFFU);
  const auto high = static_cast<char>(unit >> 8U);
  bytes += is_little ? low : high;
  bytes += is_little ? high : low;
}

void appendUtf16(std::string& bytes, utf::code_point character, bool is_little) {
  std::u16string units;
  utf::utf_traits<char16_t>::encode(character, std::back_inserter(units));
  for (const char16_t unit : units) appendUnit(bytes, unit, is_little);
}

}  // namespace

std::string_view toString(LineEnd line_end) {
  switch (line_end) {
    case LineEnd::CrLf:
      return "\r\n";
    case LineEnd::Cr:
      return "\r";
    case LineEnd::Lf:
      break;
  }
  return "\n";
}

std::string encoded(std::string_view text, Encoding encoding) {
  if (encoding == Encoding::Utf8) return std::string(text);
  if (encoding == Encoding::Utf8WithMark) return "\xEF\xBB\xBF" + std::string(text);
  std::string bytes;
  const bool is_latin = encoding == Encoding::Iso8859;
  const bool is_little = encoding == Encoding::Utf16Little;
  constexpr char16_t kByteOrderMark = 0xFEFF;
  if (!is_latin) appendUnit(bytes, kByteOrderMark, is_little);
  for (const char *next = text.data(), *const end = next + text.size(); next != end;) {
    const utf::code_point character = utf::utf_traits<char>::decode(next, end);
    if (!is_latin) {
      appendUtf16(bytes, character, is_little);
    } else {
      bytes += character <= 0xFF ? static_cast<char>(character) : '?';
    }
  }
  return bytes;
}

}  // namespace cobot_command::rapid
