// Values as bytes and as texts, control characters, tokens.
#include <algorithm>

#include "library/characters.h"
#include "library/library.h"
#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::tm_script {

namespace {

/// Every number on its own; the bytes of a text stay in their order.
Computed getBytes(const Arguments& arguments) {
  const bool is_big_endian = intAt(arguments, 1, 0) == 1;
  Bytes bytes;
  const auto add = [&](const Scalar& scalar) {
    Bytes more = bytesOf(scalar);
    if (is_big_endian && typeOf(scalar) != ScalarType::String) std::reverse(more.begin(), more.end());
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  std::visit(
      Overloaded{add,
                 [&](const Array& array) { std::for_each(array.items.begin(), array.items.end(), add); }},
      arguments[0]);
  return arrayOf(bytes);
}

template <class Number>
Scalar reversed(Number number) {
  auto* bytes = reinterpret_cast<unsigned char*>(&number);
  std::reverse(bytes, bytes + sizeof(number));
  return number;
}

Scalar reversedScalar(const Scalar& scalar) {
  return std::visit(Overloaded{[](bool flag) { return Scalar(flag); },
                               [](const std::string& text) {
                                 std::string result;
                                 for (std::size_t at = 0; at < text.size();) {
                                   const std::string_view rest = std::string_view(text).substr(at);
                                   const std::string character(rest.substr(0, byteOf(rest, 1)));
                                   at += character.size();
                                   result.insert(result.begin(), character.begin(), character.end());
                                 }
                                 return Scalar(result);
                               },
                               [](auto number) { return reversed(number); }},
                    scalar);
}

Computed valueReverse(const Arguments& arguments) {
  if (const auto* scalar = std::get_if<Scalar>(&arguments[0])) return reversedScalar(*scalar);
  Array array = arrayAt(arguments, 0);
  std::transform(array.items.begin(), array.items.end(), array.items.begin(), reversedScalar);
  return array;
}

struct Notation {
  int base = 10;
  int decimals = -1;  ///< negative: as many as the value has
};

std::string noted(const Scalar& scalar, Notation notation) {
  const bool is_integer = isInteger(typeOf(scalar));
  if (notation.base == 10 && !is_integer && isNumber(typeOf(scalar)) && notation.decimals >= 0) {
    const double value =
        typeOf(scalar) == ScalarType::Float ? std::get<float>(scalar) : std::get<double>(scalar);
    return fmt::format("{:.{}f}", value, notation.decimals);
  }
  if (notation.base == 10 || !is_integer) return textOf(scalar);
  const auto bits = typeOf(scalar) == ScalarType::Byte
                        ? std::uint32_t{std::get<std::uint8_t>(scalar)}
                        : static_cast<std::uint32_t>(std::get<std::int32_t>(scalar));
  return notation.base == 16 ? fmt::format("0x{:X}", bits) : fmt::format("0b{:b}", bits);
}

Computed getString(const Arguments& arguments) {
  constexpr int kMostDecimals = 15;
  const Notation notation{intAt(arguments, 1, 10), std::min(intAt(arguments, 2, -1), kMostDecimals)};
  if (notation.base != 10 && notation.base != 16 && notation.base != 2) {
    return refuse(std::string("the base is 10, 16 or 2"));
  }
  if (const auto* scalar = std::get_if<Scalar>(&arguments[0])) return Scalar(noted(*scalar, notation));
  std::string text = "{";
  for (const Scalar& item : arrayAt(arguments, 0).items) {
    text += (text.size() > 1 ? "," : "") + noted(item, notation);
  }
  return Scalar(text + '}');
}

/// Without prefix and suffix when they are not wanted.
std::string contentOf(const std::string& text, Token token, const Arguments& arguments, bool bare) {
  if (!bare) return text.substr(token.first, token.size);
  const std::size_t before = textAt(arguments, 1).size();
  return text.substr(token.first + before, token.size - before - textAt(arguments, 2).size());
}

std::vector<std::string> tokensOf(const Arguments& arguments, bool bare, std::size_t most) {
  const std::string& text = textAt(arguments, 0);
  std::vector<std::string> tokens;
  for (Token token{0, 0}; tokens.size() < most;) {
    token = findToken(text, textAt(arguments, 1), textAt(arguments, 2), token.first + token.size);
    if (token.first == kNotFound || token.size == 0) break;
    tokens.push_back(contentOf(text, token, arguments, bare));
  }
  return tokens;
}

Computed getToken(const Arguments& arguments) {
  const int occurrence = intAt(arguments, 3, 1);
  if (occurrence < 1) return Scalar(std::string());
  const auto wanted = static_cast<std::size_t>(occurrence);
  const auto tokens = tokensOf(arguments, intAt(arguments, 4, 0) == 1, wanted);
  return Scalar(tokens.size() == wanted ? tokens.back() : std::string());
}

Computed getAllTokens(const Arguments& arguments) {
  return arrayOf(tokensOf(arguments, intAt(arguments, 3, 0) == 1, kMaxElements + 1));
}

Computed length(const Arguments& arguments) {
  const Value& value = arguments[0];
  if (const auto* array = std::get_if<Array>(&value)) {
    return Scalar(static_cast<std::int32_t>(array->items.size()));
  }
  const auto* text = std::get_if<std::string>(&std::get<Scalar>(value));
  return Scalar(static_cast<std::int32_t>(text ? characterCount(*text) : sizeOf(value)));
}

/// \r, \n, \t ... \xHH in a text become the characters that they name; other backslashes stay.
std::string unescaped(const std::string& text) {
  constexpr std::string_view kNames = "0abtnvfre";
  constexpr std::string_view kCharacters{"\0\a\b\t\n\v\f\r\x1B", 9};
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t name =
        text[at] == '\\' && at + 1 < text.size() ? kNames.find(text[at + 1]) : kNames.npos;
    result += name == kNames.npos ? text[at] : kCharacters[name];
    if (name != kNames.npos) ++at;
  }
  return result;
}

/// The bytes of a number, the highest first, without the zeros in front: 0x0D0A is CR LF.
Computed controlOf(const Arguments& arguments) {
  Bytes bytes = bytesOf(std::get<Scalar>(arguments[0]));
  while (bytes.size() > 1 && bytes.back() == 0) bytes.pop_back();
  std::reverse(bytes.begin(), bytes.end());
  return Scalar(textOf(bytes));
}

}  // namespace

void defineTextFunctions(FunctionTable& table) {
  table.define("byte[] GetBytes(any, int?)", kSinceEver, getBytes);
  table.define("byte[] GetBytes(any[], int?)", kSinceEver, getBytes);
  table.define("any ValueReverse(any)", kSinceEver, valueReverse);
  table.define("any[] ValueReverse(any[])", kSinceEver, valueReverse);
  table.define("string GetString(any, int?, int?)", kSinceEver, getString);
  table.define("string GetString(any[], int?, int?)", kSinceEver, getString);
  table.define("string GetToken(string, string, string, int?, int?)", kSinceEver, getToken);
  table.define("string[] GetAllTokens(string, string, string, int?)", kSinceEver, getAllTokens);
  table.define("int Length(any)", kSinceEver, length);
  table.define("int Length(any[])", kSinceEver, length);
  table.define("string Ctrl(int)", kSinceEver, controlOf);
  table.define("string Ctrl(string)", kSinceEver, [](const Arguments& arguments) -> Computed {
    return Scalar(unescaped(textAt(arguments, 0)));
  });
  table.define("string Ctrl(byte[])", kSinceEver, [](const Arguments& arguments) -> Computed {
    return Scalar(textOf(itemsAt<std::uint8_t>(arguments, 0)));
  });
}

}  // namespace cobot_command::tm_script
