#include "cobot_command/rapid/types/cells.h"

#include <cassert>
#include <iterator>

#include <boost/locale/utf.hpp>

namespace cobot_command::rapid {

namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

}  // namespace

std::string_view stringIn(const Cell* cells) {
  const char* const bytes = reinterpret_cast<const char*>(cells);
  return {bytes + 1, static_cast<unsigned char>(*bytes)};
}

void putString(std::string_view bytes, Cell* cells) {
  assert(bytes.size() <= kMostTextCharacters);
  char* const target = reinterpret_cast<char*>(cells);
  std::memset(target, 0, kStringCells * sizeof(Cell));
  *target = static_cast<char>(bytes.size());
  if (!bytes.empty()) std::memcpy(target + 1, bytes.data(), bytes.size());
}

std::optional<std::string> latin1(std::string_view utf8) {
  constexpr boost::locale::utf::code_point kLast = 0xFF;
  std::string result;
  for (const char* at = utf8.begin(); at != utf8.end();) {
    const auto code = Utf8::decode(at, utf8.end());
    if (code > kLast) return std::nullopt;  // also what is not UTF-8
    result += static_cast<char>(code);
  }
  return result;
}

std::string utf8(std::string_view latin1) {
  std::string result;
  for (const char c : latin1) Utf8::encode(static_cast<unsigned char>(c), std::back_inserter(result));
  return result;
}

}  // namespace cobot_command::rapid
