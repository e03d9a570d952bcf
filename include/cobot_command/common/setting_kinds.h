// The kinds of settings that every table needs. Each takes only its own type: no real number for a whole one,
// no text for a number, nothing that is not finite.
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

/// 1 and 0 are true and false, as `rosrun` makes whole numbers of `_parameter:=1`.
[[nodiscard]] SettingKind flag(bool& value);
[[nodiscard]] SettingKind whole(int& value, int lowest, int highest, const std::string& unit = {});
[[nodiscard]] SettingKind port(int& value);  ///< 0 to 65535
[[nodiscard]] SettingKind real(double& value, double lowest, double highest, const std::string& unit = {});
/// Written in a unit of which one of the variable's has so many: limits in that unit.
[[nodiscard]] SettingKind realIn(double& value, double lowest, double highest, const std::string& unit,
                                 double units_in_one);
/// Limits in seconds.
[[nodiscard]] SettingKind seconds(Duration& value, double lowest, double highest);
/// Absent is written as -1.
[[nodiscard]] SettingKind secondsOrNever(std::optional<Duration>& value, double lowest, double highest);

/// Which texts a setting takes, and in words.
struct TextRule {
  std::string allowed;
  std::function<bool(const std::string&)> holds;
};
[[nodiscard]] TextRule anyText();
/// What people see on one line: not empty, UTF-8.
[[nodiscard]] TextRule name(std::size_t longest);
[[nodiscard]] TextRule oneOf(const std::vector<std::string>& words);
[[nodiscard]] TextRule orEmpty(TextRule rule);
[[nodiscard]] SettingKind text(std::string& value, const TextRule& rule = anyText());
/// A list of texts, from the start none; who takes them says what each may be.
[[nodiscard]] SettingKind texts(std::vector<std::string>& value, const std::string& allowed);

/// A value that is written as a text: `read` makes it of one or says what is wrong, `show` is the way back.
template <class Value>
[[nodiscard]] SettingKind written(Value& value, std::string allowed,
                                  std::function<Result<Value, std::string>(const std::string&)> read,
                                  std::function<std::string(const Value&)> show);
/// The word for each value of an enumeration.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;
template <class Value>
[[nodiscard]] SettingKind choice(Value& value, Words<Value> words);

/// The texts of a list, if it is one. The error is what was found.
[[nodiscard]] Result<std::vector<std::string>, std::string> textsIn(const Given& given);
/// A finite number, whole or not; nothing when it is none.
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
