// The elements and attributes of WATERS modules.
#pragma once

#include <string>

namespace cobot_command::automata::wmod {

inline constexpr const char* kNamespace = "http://waters.sourceforge.net/xsd/module";
inline constexpr const char* kAccepting = ":accepting";
/// Of a comment "name: written = meant".
inline constexpr const char* kMeaning = "name: ";

/// Two hyphens would end a comment.
inline std::string toComment(std::string text) {
  for (auto at = text.find("--"); at != std::string::npos; at = text.find("--")) {
    text.replace(at + 1, 1, "&#45;");
  }
  return text;
}

inline std::string fromComment(std::string text) {
  for (auto at = text.find("&#45;"); at != std::string::npos; at = text.find("&#45;")) {
    text.replace(at, 5, "-");
  }
  return text;
}

}  // namespace cobot_command::automata::wmod
