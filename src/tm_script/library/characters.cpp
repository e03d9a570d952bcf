#include "library/characters.h"

#include <boost/locale/utf.hpp>

namespace cobot_command::tm_script {

namespace {

/// Precondition: bytes is not empty.
std::size_t characterSize(std::string_view bytes) {
  const char* next = bytes.data();
  const auto code_point = boost::locale::utf::utf_traits<char>::decode(next, bytes.data() + bytes.size());
  return boost::locale::utf::is_valid_codepoint(code_point) ? static_cast<std::size_t>(next - bytes.data())
                                                            : 1;
}

}  // namespace

std::size_t characterCount(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(characterSize(text));
  return count;
}

std::size_t byteOf(std::string_view text, std::size_t character) {
  std::size_t byte = 0;
  for (; character > 0 && byte < text.size(); --character) byte += characterSize(text.substr(byte));
  return byte;
}

Token findToken(std::string_view text, std::string_view prefix, std::string_view suffix, std::size_t start) {
  const std::size_t first = text.find(prefix, start);
  if (first == kNotFound) return {kNotFound, 0};
  if (suffix.empty()) return {first, text.size() - first};
  const std::size_t last = text.find(suffix, first + prefix.size());
  if (last == kNotFound) return {kNotFound, 0};
  return {first, last + suffix.size() - first};
}

}  // namespace cobot_command::tm_script
