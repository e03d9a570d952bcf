#include "item_string.h"

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::protocol {

namespace {

constexpr char kQuote = '"';

bool isEnclosed(std::string_view text, char open, char close) {
  return text.size() >= 2 && text.front() == open && text.back() == close;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<JsonTree> readText(std::string_view quoted_text) {
  std::string text;
  std::string_view rest = quoted_text.substr(1, quoted_text.size() - 2);
  for (; !rest.empty(); rest.remove_prefix(1)) {
    if (rest.front() == kQuote) {
      rest.remove_prefix(1);
      if (rest.empty() || rest.front() != kQuote) return std::nullopt;
    }
    text += rest.front();
  }
  if (!isUtf8(text)) return std::nullopt;
  return JsonTree(text);
}

std::optional<JsonTree> readScalar(std::string_view text) {
  if (isEnclosed(text, kQuote, kQuote)) return readText(text);
  auto json = parseJson(text);
  if (!json || !(json->is_number() || json->is_boolean())) return std::nullopt;
  return json;
}

}  // namespace

std::string inQuotes(std::string_view text) {
  std::string result(1, kQuote);
  for (const char c : text) result.append(c == kQuote ? 2 : 1, c);
  return result + kQuote;
}

std::string_view takeUnquoted(std::string_view separator, std::string_view& text) {
  bool in_quotes = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == kQuote) in_quotes = !in_quotes;
    if (!in_quotes && text.substr(at, separator.size()) == separator) {
      const std::string_view part = text.substr(0, at);
      text.remove_prefix(at + separator.size());
      return part;
    }
  }
  const std::string_view all = text;
  text = {};
  return all;
}

std::optional<JsonTree> readStringValue(std::string_view text) {
  text = trimmed(text);
  if (!isEnclosed(text, '{', '}')) return readScalar(text);
  JsonTree array = JsonTree::array();
  std::string_view rest = trimmed(text.substr(1, text.size() - 2));
  bool more = !rest.empty();
  while (more) {
    const std::size_t before = rest.size();
    const std::string_view element = takeUnquoted(",", rest);
    more = element.size() < before;  // a separator was there
    const auto value = readScalar(trimmed(element));
    if (!value) return std::nullopt;
    array.push_back(*value);
  }
  return array;
}

}  // namespace cobot_command::protocol
