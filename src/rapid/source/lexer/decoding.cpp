#include "lexer/decoding.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reporting.h"
#include <boost/locale/utf.hpp>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/source/finding_kinds.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

namespace {

namespace utf = boost::locale::utf;

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kUtf16LittleMark = "\xFF\xFE";
constexpr std::string_view kUtf16BigMark = "\xFE\xFF";

bool beginsWith(std::string_view bytes, std::string_view mark) {
  return bytes.substr(0, mark.size()) == mark;
}

void append(std::string& text, utf::code_point character) {
  utf::utf_traits<char>::encode(character, std::back_inserter(text));
}

Result<DecodedText, Finding> fromUtf8WithMark(std::string_view bytes) {
  bytes.remove_prefix(kUtf8Mark.size());
  if (!isUtf8(bytes)) {
    return refuse(finding(kinds::kUnreadable, {}, "it begins as UTF-8, and is not; save it again"));
  }
  return DecodedText{std::string(bytes), Encoding::Utf8WithMark};
}

Result<DecodedText, Finding> fromUtf16(std::string_view bytes, Encoding encoding) {
  bytes.remove_prefix(kUtf16BigMark.size());
  std::u16string units;
  units.reserve(bytes.size() / 2);
  const std::size_t high = encoding == Encoding::Utf16Big ? 0 : 1;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(bytes[i + index]); };
    units += static_cast<char16_t>(byte(high) << 8U | byte(1 - high));
  }
  DecodedText decoded{{}, encoding};
  bool is_valid = bytes.size() % 2 == 0;
  for (const char16_t *next = units.data(), *const end = next + units.size(); is_valid && next != end;) {
    const utf::code_point character = utf::utf_traits<char16_t>::decode(next, end);
    is_valid = utf::is_valid_codepoint(character);
    if (is_valid) append(decoded.text, character);
  }
  if (is_valid) return decoded;
  return refuse(finding(kinds::kUnreadable, {}, "it begins as UTF-16, and is not; save it again"));
}

DecodedText fromLatin(std::string_view bytes) {
  DecodedText decoded{{}, Encoding::Iso8859};
  decoded.text.reserve(bytes.size() + bytes.size() / 16);
  for (const char byte : bytes) append(decoded.text, static_cast<unsigned char>(byte));
  return decoded;
}

Result<DecodedText, Finding> fromAny(std::string_view bytes) {
  if (beginsWith(bytes, kUtf8Mark)) return fromUtf8WithMark(bytes);
  if (beginsWith(bytes, kUtf16LittleMark)) return fromUtf16(bytes, Encoding::Utf16Little);
  if (beginsWith(bytes, kUtf16BigMark)) return fromUtf16(bytes, Encoding::Utf16Big);
  const bool is_ascii =
      std::all_of(bytes.begin(), bytes.end(), [](char byte) { return static_cast<signed char>(byte) >= 0; });
  if (is_ascii || isUtf8(bytes)) return DecodedText{std::string(bytes), Encoding::Utf8};
  return fromLatin(bytes);
}

bool isControlOfBinary(char c) {
  return isControl(c) && c != '\t' && c != '\n' && c != '\r' && c != '\f';
}

/// NOVIEW modules are encoded, and so are other things that are no text.
bool isBinary(std::string_view text) {
  constexpr std::size_t kChecked = 4096;  // [bytes]
  constexpr std::ptrdiff_t kOneInSo = 20;
  const std::string_view beginning = text.substr(0, kChecked);
  const auto controls = std::count_if(beginning.begin(), beginning.end(), isControlOfBinary);
  return text.find('\0') != std::string_view::npos ||
         controls * kOneInSo > static_cast<std::ptrdiff_t>(beginning.size());
}

}  // namespace

Result<DecodedText, Finding> decoded(std::string_view bytes) {
  if (bytes.size() > kMostFileBytes) return refuse(finding(kinds::kLongFile, {}, kMostFileBytes >> 20U));
  auto text = fromAny(bytes);
  if (text && isBinary(text->text)) return refuse(finding(kinds::kNoSourceText, {}));
  return text;
}

}  // namespace cobot_command::rapid
