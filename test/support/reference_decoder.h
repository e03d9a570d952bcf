// A frame decoder that is plain instead of fast: it looks at the whole stream at once and may take its time.
// The decoder proper is compared with it on every small input that there is.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cobot_command::protocol::reference {

/// "HEADER:DATA" for a frame, the kind for a fault.
using Events = std::vector<std::string>;

/// Nothing: not a length. Reads by value, so "0x10" is 16.
inline std::optional<std::size_t> lengthOf(std::string_view field) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  unsigned base = 10;
  std::string digits(field);
  if (digits.substr(0, 2) == "0x" || digits.substr(0, 2) == "0b") {
    base = digits[1] == 'x' ? 16 : 2;
    digits.erase(0, 2);
  }
  if (digits.empty() || field.size() > 34) return std::nullopt;
  std::size_t value = 0;
  for (const char c : digits) {
    const std::size_t digit = kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    if (digit >= base) return std::nullopt;
    value = value * base + digit;
    if (value > std::size_t{16} * 1024 * 1024) return std::nullopt;
  }
  return value;
}

struct Attempt {
  std::string event;      ///< empty: more bytes are needed
  std::size_t whole = 0;  ///< bytes of a frame whose end is known
};

inline Attempt attempt(std::string_view s) {
  const std::size_t comma = std::min(s.find_first_of(",$\r\n", 1), s.size());
  if (comma > 17 || (comma < s.size() && s[comma] != ',')) return {"header", 0};
  if (comma == s.size()) return {};
  const std::string_view rest = s.substr(comma + 1);
  const std::string_view field = rest.substr(0, std::min(rest.find(','), rest.size()));
  const auto length = lengthOf(field);
  if (field.size() == rest.size() && (length || field.empty() || field == "0x" || field == "0b")) return {};
  if (!length) return {"length", 0};

  const std::size_t data = comma + 1 + field.size() + 1;
  const std::size_t end = data + *length;
  const std::string_view expected = ",*??\r\n";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (end + i >= s.size()) return {};
    if (expected[i] != '?' && s[end + i] != expected[i]) return {"length", 0};
  }
  unsigned sum = 0;
  for (const char c : s.substr(1, end)) sum ^= static_cast<unsigned char>(c);
  std::string digits = {"0123456789ABCDEF"[sum >> 4u], "0123456789ABCDEF"[sum & 15u]};
  for (std::size_t i = 0; i < 2; ++i) {
    if (digits[i] != std::toupper(static_cast<unsigned char>(s[end + 2 + i]))) return {"checksum", end + 6};
  }
  const std::string header(s.substr(1, comma - 1));
  const auto letter = [](unsigned char c) { return c < 0x80 && std::isalpha(c) != 0; };
  if (header.empty() || !std::all_of(header.begin(), header.end(), letter)) return {"header", end + 6};
  return {header + ":" + std::string(s.substr(data, *length)), end + 6};
}

inline Events decode(std::string_view s) {
  const auto starts = [](std::string_view text, std::size_t i) {
    return text[i] == '$' && i + 1 < text.size() &&
           std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0;
  };
  Events events;
  while (!s.empty()) {
    bool reported = false;
    if (s.front() == '$') {
      const Attempt tried = attempt(s);
      if (tried.event.empty()) return events;
      events.push_back(tried.event);
      s.remove_prefix(std::max<std::size_t>(tried.whole, 1));
      if (tried.whole > 0) continue;
      reported = true;
    }
    std::size_t start = 0;
    while (start < s.size() && !starts(s, start)) ++start;
    const bool found = start < s.size();
    const std::size_t surely = !found && start > 0 && s.back() == '$' ? start - 1 : start;
    if (!reported && (found || surely >= 256)) events.emplace_back("garbage");
    s.remove_prefix(start);
  }
  return events;
}

}  // namespace cobot_command::protocol::reference
