#include "formats/format_names.h"

#include <fmt/format.h>

namespace cobot_command::automata {
namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

std::string allowed(const std::string& name) {
  std::string text;
  for (const char c : name) text += isLetter(c) || isDigit(c) ? c : '_';
  if (text.empty() || isDigit(text.front())) text.insert(0, "_");
  return text;
}

}  // namespace

const std::string& FormatNames::of(const std::string& name) {
  const auto known = names_.find(name);
  if (known != names_.end()) return known->second;
  const std::string wanted = allowed(name);
  std::string written = wanted;
  for (int number = 2; !taken_.insert(written).second; ++number) {
    written = fmt::format("{}_{}", wanted, number);
  }
  return names_.emplace(name, written).first->second;
}

std::vector<std::string> FormatNames::table() const {
  std::vector<std::string> lines;
  for (const auto& [meant, written] : names_) {
    if (meant != written) lines.push_back(fmt::format("{} = {}", written, meant));
  }
  return lines;
}

}  // namespace cobot_command::automata
