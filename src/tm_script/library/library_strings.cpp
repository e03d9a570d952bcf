// Texts: searching, cutting and converting them. Places are counted in characters, from 0.
#include <algorithm>

#include "library/characters.h"
#include "library/library.h"
#include "values/conversion.h"
#include "values/numerals.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

/// A text that is no number is 0.
Computed integer(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  const int base = intAt(arguments, 1, 10);
  if (base != 10 && base != 16 && base != 2) return refuse(std::string("the base is 10, 16 or 2"));
  std::string numeral = text;
  if (base != 10 && text.find_first_of("xXbB") != 1) numeral = (base == 16 ? "0x" : "0b") + text;
  auto number = convert(Scalar(numeral), ScalarType::Int);
  return number ? std::move(*number) : Scalar(0);
}

template <class Real>
Computed real(const Arguments& arguments) {
  if (intAt(arguments, 1, 10) != 10) return refuse(std::string("only the base 10 is simulated"));
  return Scalar(static_cast<Real>(numberIn(textAt(arguments, 0)).value_or(0)));
}

Computed bytes(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  const int encoding = intAt(arguments, 1, 0);
  if (encoding == 0) return arrayOf(bytesOf(text));
  Bytes result;
  if (encoding == 2) {
    for (std::size_t at = 0; at < text.size(); at = byteOf(std::string_view(text).substr(at), 1) + at) {
      result.push_back(static_cast<unsigned char>(text[at]) > 0x7F ? '?'
                                                                   : static_cast<std::uint8_t>(text[at]));
    }
    return arrayOf(result);
  }
  if (encoding != 1) return refuse(std::string("the encoding is 0, 1 or 2"));
  for (std::size_t at = 0; at < text.size(); at += 2) {
    const auto byte =
        text.size() - at < 2 ? std::nullopt : parseDigits(std::string_view(text).substr(at, 2), 16);
    if (!byte) return refuse(fmt::format("\"{}\" is no pair of hexadecimal digits", text.substr(at, 2)));
    result.push_back(static_cast<std::uint8_t>(*byte));
  }
  return arrayOf(result);
}

Computed place(const std::string& text, std::size_t byte) {
  if (byte == std::string::npos) return Scalar(-1);
  return Scalar(static_cast<std::int32_t>(characterCount(std::string_view(text).substr(0, byte))));
}

/// From a byte, so many characters; all of the rest for a negative number.
std::string cut(const std::string& text, std::size_t byte, int length) {
  std::string rest = text.substr(std::min(byte, text.size()));
  if (length >= 0) rest.resize(byteOf(rest, static_cast<std::size_t>(length)));
  return rest;
}

Computed substringAt(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  const int start = intAt(arguments, 1, 0);
  if (start < 0) return Scalar(std::string());
  return Scalar(cut(text, byteOf(text, static_cast<std::size_t>(start)), intAt(arguments, 2, -1)));
}

Computed substringFrom(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  return Scalar(cut(text, text.find(textAt(arguments, 1)), intAt(arguments, 2, -1)));
}

Computed substringBetween(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  Token token{0, 0};
  for (int occurrence = intAt(arguments, 3, 1); occurrence > 0; --occurrence) {
    token = findToken(text, textAt(arguments, 1), textAt(arguments, 2), token.first + token.size);
    if (token.first == kNotFound) return Scalar(std::string());
    if (token.size == 0) break;
  }
  return Scalar(text.substr(token.first, token.size));
}

/// Modes: +1 drops empty parts, +2 leaves separators within quotes alone.
Computed split(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  const std::string& separator = textAt(arguments, 1);
  const int mode = intAt(arguments, 2, 0);
  if (mode < 0 || mode > 3) return refuse(std::string("the mode is 0 to 3"));
  std::vector<std::string> parts{""};
  bool in_quotes = false;
  for (std::size_t at = 0; at < text.size();) {
    if (!in_quotes && !separator.empty() && text.compare(at, separator.size(), separator) == 0) {
      parts.emplace_back();
      at += separator.size();
      continue;
    }
    if (text[at] == '"' && mode >= 2) in_quotes = !in_quotes;
    parts.back() += text[at++];
  }
  if (mode % 2 == 1) parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return arrayOf(parts);
}

Computed replace(const Arguments& arguments) {
  const std::string& text = textAt(arguments, 0);
  const std::string& old = textAt(arguments, 1);
  if (old.empty()) return Scalar(text);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool found = text.compare(at, old.size(), old) == 0;
    result += found ? textAt(arguments, 2) : text.substr(at, 1);
    at += found ? old.size() : 1;
    if (result.size() > kMaxValueBytes) {
      return refuse(fmt::format("a text of more than {} bytes", kMaxValueBytes));
    }
  }
  return Scalar(result);
}

Computed trim(const Arguments& arguments) {
  constexpr const char* kBlanks = " \t\r\n\v\f";
  std::string_view text = textAt(arguments, 0);
  if (arguments.size() == 1) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return Scalar(std::string(text.substr(0, text.find_last_not_of(kBlanks) + 1)));
  }
  const std::string& lead = textAt(arguments, 1);
  while (!lead.empty() && text.substr(0, lead.size()) == lead) text.remove_prefix(lead.size());
  const std::string trail = arguments.size() > 2 ? textAt(arguments, 2) : "";
  while (!trail.empty() && text.size() >= trail.size() && text.substr(text.size() - trail.size()) == trail) {
    text.remove_suffix(trail.size());
  }
  return Scalar(std::string(text));
}

/// Changes the letters of ASCII from one case to the other.
Builtin shifted(char first, char last, int shift) {
  return [=](const Arguments& arguments) -> Computed {
    std::string text = textAt(arguments, 0);
    for (char& c : text) {
      if (c >= first && c <= last) c = static_cast<char>(c + shift);
    }
    return Scalar(text);
  };
}

}  // namespace

void defineStringFunctions(FunctionTable& table) {
  constexpr int kCaseDistance = 'a' - 'A';
  table.define("int String_ToInteger(string, int?)", kSinceEver, integer);
  table.define("float String_ToFloat(string, int?)", kSinceEver, real<float>);
  table.define("double String_ToDouble(string, int?)", kSinceEver, real<double>);
  table.define("byte[] String_ToByte(string, int?)", kSinceEver, bytes);
  table.define("int String_IndexOf(string, string)", kSinceEver, [](const Arguments& arguments) {
    return place(textAt(arguments, 0), textAt(arguments, 0).find(textAt(arguments, 1)));
  });
  table.define("int String_LastIndexOf(string, string)", kSinceEver, [](const Arguments& arguments) {
    return place(textAt(arguments, 0), textAt(arguments, 0).rfind(textAt(arguments, 1)));
  });
  table.define("string String_Substring(string, int, int?)", kSinceEver, substringAt);
  table.define("string String_Substring(string, string, int?)", kSinceEver, substringFrom);
  table.define("string String_Substring(string, string, string, int?)", kSinceEver, substringBetween);
  table.define("string[] String_Split(string, string, int?)", kSinceEver, split);
  table.define("string String_Replace(string, string, string)", kSinceEver, replace);
  table.define("string String_Trim(string, string?, string?)", kSinceEver, trim);
  table.define("string String_ToLower(string)", kSinceEver, shifted('A', 'Z', kCaseDistance));
  table.define("string String_ToUpper(string)", kSinceEver, shifted('a', 'z', -kCaseDistance));
}

}  // namespace cobot_command::tm_script
