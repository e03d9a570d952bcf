// Whole numbers on the command line, as people write them.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

namespace cobot_command::tools {

/// Of an option with a whole number from `least` to `most`. The library would read 010 as 8, take 0x10, and
/// make the largest number there is of one that is too long.
[[nodiscard]] inline CLI::Validator isWhole(std::int64_t least, std::int64_t most) {
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  CLI::Validator validator(
      [least, most, range](std::string& text) -> std::string {
        std::int64_t number = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, number);
        if (read.ec != std::errc() || read.ptr != end || number < least || number > most) {
          return text + " is not a whole number from " + range;
        }
        text = std::to_string(number);
        return {};
      },
      "a whole number, " + range);
  return validator;
}

}  // namespace cobot_command::tools
