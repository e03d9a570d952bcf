// The common kinds of settings. Each accepts only its own type: no real number for a whole number, no text
// for a number, no number that is not finite.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/common/time.h"

namespace cobot_command::setting_kinds {

/// Also accepts 1 and 0, because `rosrun` passes `_parameter:=1` as a whole number.
[[nodiscard]] SettingKind flag(bool& value);
[[nodiscard]] SettingKind whole(int& value, int lowest, int highest, const std::string& unit = {});
[[nodiscard]] SettingKind port(int& value);  ///< 0 to 65535
[[nodiscard]] SettingKind real(double& value, double lowest, double highest, const std::string& unit = {});
/// Value and limits are given in `unit`; one unit of the variable is `units_in_one` of it.
[[nodiscard]] SettingKind realIn(double& value, double lowest, double highest, const std::string& unit,
                                 double units_in_one);
/// Limits in seconds.
[[nodiscard]] SettingKind seconds(Duration& value, double lowest, double highest);
/// -1 means absent (never).
[[nodiscard]] SettingKind secondsOrNever(std::optional<Duration>& value, double lowest, double highest);

/// A condition on a text, and its description.
struct TextRule {
  std::string allowed;
  std::function<bool(const std::string&)> holds;
};
[[nodiscard]] TextRule anyText();
/// A name on one line: not empty, at most `longest` bytes, UTF-8, no control characters.
[[nodiscard]] TextRule name(std::size_t longest);
[[nodiscard]] TextRule oneOf(const std::vector<std::string>& words);
[[nodiscard]] TextRule orEmpty(TextRule rule);
[[nodiscard]] SettingKind text(std::string& value, const TextRule& rule = anyText());
/// A list of texts. The default is shown as "none". The user of the list checks its entries.
[[nodiscard]] SettingKind texts(std::vector<std::string>& value, const std::string& allowed);

/// A value that is written as a text: `read` converts the text or returns the error, `show` converts it back.
template <class Value>
[[nodiscard]] SettingKind written(Value& value, std::string allowed,
                                  std::function<Result<Value, std::string>(const std::string&)> read,
                                  std::function<std::string(const Value&)> show);
/// The name of each value of an enumeration.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;
template <class Value>
[[nodiscard]] SettingKind choice(Value& value, Words<Value> words);

/// The texts of a list. The error is what was found.
[[nodiscard]] Result<std::vector<std::string>, std::string> textsIn(const Given& given);
/// A finite number, whole or real; std::nullopt otherwise.
[[nodiscard]] std::optional<double> finiteIn(const Given& given);
/// "binary, string or json"
[[nodiscard]] std::string enumerated(const std::vector<std::string>& words);
/// "is the text "abc""
[[nodiscard]] std::string isFound(const Given& given);

// ---

template <class Value>
SettingKind written(Value& value, std::string allowed,
                    std::function<Result<Value, std::string>(const std::string&)> read,
                    std::function<std::string(const Value&)> show) {
  SettingKind kind;
  kind.type = std::move(allowed);
  kind.take = [&value, read = std::move(read)](const Given& given) -> std::optional<std::string> {
    const auto* words = std::get_if<std::string>(&given.value);
    if (words == nullptr) return isFound(given) + ", no text";
    auto made = read(*words);
    if (!made) return made.error();
    value = std::move(*made);
    return std::nullopt;
  };
  kind.show = [&value, show = std::move(show)] { return show(value); };
  return kind;
}

template <class Value>
SettingKind choice(Value& value, Words<Value> words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  const auto read = [words](const std::string& text) -> Result<Value, std::string> {
    for (const auto& [name, meant] : words) {
      if (name == text) return meant;
    }
    return refuse(isFound({text}));
  };
  const auto show = [words](const Value& shown) {
    std::string found;
    for (const auto& [name, meant] : words) {
      if (meant == shown) found = name;
    }
    return found;
  };
  return written<Value>(value, enumerated(names), read, show);
}

}  // namespace cobot_command::setting_kinds
