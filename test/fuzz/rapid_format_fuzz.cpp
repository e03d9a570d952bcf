// Any bytes as a RAPID file: what has no syntax error is printed with the same tokens, and the second time
// with the same bytes.
#include <cstdint>
#include <string>
#include <string_view>

#include "require.h"

#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/types/predefined.h"

using namespace cobot_command::rapid;

namespace {

/// Case counts only in comments, texts and numbers.
std::string tokenText(const Source& source, TokenIndex token) {
  const TokenKind kind = source.tokens()[token].kind;
  const std::string text(source.textOf(token));
  const bool has_case = kind == TokenKind::Comment || kind == TokenKind::Text || kind == TokenKind::Number;
  return has_case ? text : folded(text);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Source source = readSource(std::string_view(reinterpret_cast<const char*>(data), size));
  if (source.isBroken()) return 0;
  const std::string once = print(source, predefinedNames());
  const std::string bytes = encoded(once, source.encoding());
  const Source again = readSource(bytes);
  REQUIRE(!again.isBroken());
  REQUIRE(again.tokens().size() == source.tokens().size());
  for (TokenIndex token = 0; token < source.tokens().size(); ++token) {
    REQUIRE(again.tokens()[token].kind == source.tokens()[token].kind);
    REQUIRE(tokenText(again, token) == tokenText(source, token));
  }
  REQUIRE(print(again, predefinedNames()) == once);
  return 0;
}
