#include "preview/first_words.h"

#include <algorithm>

namespace cobot_command::rviz_plugin {
namespace {

constexpr std::size_t kLongest = 80;

/// The bytes of UTF-8 that a character has after its first one.
bool goesOn(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace

std::string firstWords(const std::string& reason) {
  std::string text = reason.substr(0, std::min(reason.find(": "), reason.find(". ")));
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (goesOn(text[at]) || ++characters <= kLongest) continue;
    return text.substr(0, at) + " ...";
  }
  return text;
}

}  // namespace cobot_command::rviz_plugin
