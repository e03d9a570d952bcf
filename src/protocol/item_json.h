// JSON as the status port uses it: no exceptions, no nesting beyond what items need.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace cobot_command::protocol {

using JsonTree = nlohmann::json;

/// An array of objects with an array in them.
inline constexpr int kDeepestJson = 3;

/// Nothing for what is no JSON, or nested deeper than an array of items can be.
[[nodiscard]] inline std::optional<JsonTree> parseJson(std::string_view text) {
  if (text.empty()) return std::nullopt;
  bool too_deep = false;
  const auto watch = [&](int depth, JsonTree::parse_event_t event, JsonTree&) {
    const bool opens =
        event == JsonTree::parse_event_t::array_start || event == JsonTree::parse_event_t::object_start;
    too_deep = too_deep || (opens && depth >= kDeepestJson);
    return !too_deep;
  };
  JsonTree json = JsonTree::parse(text.begin(), text.end(), watch, false);
  if (json.is_discarded() || too_deep) return std::nullopt;
  return json;
}

/// On one line; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] inline std::string toText(const JsonTree& json) {
  return json.dump(-1, ' ', false, JsonTree::error_handler_t::replace);
}

}  // namespace cobot_command::protocol
