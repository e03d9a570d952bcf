// Names of value-parameterised tests that tell the value.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace cobot_command {

/// "7_TMSCT_script_4_rejected": letters and digits of the text, behind the index, which keeps it unique.
inline std::string testName(std::size_t index, std::string_view text) {
  std::string name = std::to_string(index) + '_';
  for (const char c : text.substr(0, 60)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain || name.back() != '_') name += plain ? c : '_';
  }
  return name;
}

/// For parameters that are text.
inline const auto kTextAsName = [](const auto& info) { return testName(info.index, info.param); };

}  // namespace cobot_command
