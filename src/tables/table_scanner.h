// Reads an entry of the tables, from left to right, and knows where it does not go on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::tables {

/// "3=gripper:0,0,150,0,0,0@1" in its parts.
struct EntryText {
  int index = 0;
  std::optional<std::string> name;
  std::vector<double> numbers;
  std::optional<int> refers_to;  ///< behind the @
};

/// What ends an entry besides the end of its text.
enum class EntryEnd { Text, TextOrComment };

/// The error is the reason, with the place in the text; `before`: how many characters stand in front of it in
/// what the fault shows.
[[nodiscard]] Result<EntryText, std::string> scanEntry(std::string_view text, EntryEnd end,
                                                       std::size_t before);

/// Can stand without quotes.
[[nodiscard]] bool isBareName(std::string_view name);

}  // namespace cobot_command::tables
