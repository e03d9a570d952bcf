#include "lexer/text_scan.h"

#include "cobot_command/common/utf8.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

namespace {

constexpr std::string_view kHexDigits = "0123456789abcdefABCDEF";

bool isHexDigit(std::string_view text, std::size_t at) {
  return at < text.size() && kHexDigits.find(text[at]) != std::string_view::npos;
}

/// A backslash and the two characters that should be digits, as far as they are in the text.
Span badCode(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  for (int characters = 0; characters < 2 && end < text.size(); ++characters) {
    if (std::string_view("\"\r\n").find(text[end]) != std::string_view::npos) break;
    ++end;
    while (end < text.size() && !beginsCharacter(text[end])) ++end;
  }
  return {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
}

}  // namespace

TextScan scanText(std::string_view text) {
  TextScan scan;
  std::size_t at = 1;
  while (at < text.size()) {
    const char c = text[at];
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    if (c == '\n' || c == '\r') break;
    if (c == '"' && next != '"') {
      scan.is_closed = true;
      ++at;
      break;
    }
    if (c == '"' || (c == '\\' && next == '\\')) {
      at += 2;
    } else if (c == '\\' && isHexDigit(text, at + 1) && isHexDigit(text, at + 2)) {
      at += 3;
    } else {
      // More of them would not be reported anyway.
      if (c == '\\' && scan.bad_codes.size() <= kMostFindings) scan.bad_codes.push_back(badCode(text, at));
      ++at;
    }
    if (beginsCharacter(c)) ++scan.characters;
  }
  scan.size = at;
  if (!scan.is_closed) scan.size = text.substr(0, at).find_last_not_of(" \t\f") + 1;
  return scan;
}

}  // namespace cobot_command::rapid
