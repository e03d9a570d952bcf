#include "cobot_command/common/setting_kinds.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::setting_kinds {

namespace {

using Form = SettingKind::Form;

constexpr double kNever = -1;

std::string orEmptyShown(const std::string& text) {
  return text.empty() ? "empty" : text;
}

/// Durations in a unit of which a second has so many.
SettingKind duration(Duration& value, double lowest, double highest, const std::string& unit,
                     double units_in_second) {
  SettingKind kind;
  kind.form = Form::Number;
  kind.type = "a number";
  kind.range = fmt::format("{} to {}", lowest * units_in_second, highest * units_in_second);
  kind.unit = unit;
  kind.take = [&value, lowest, highest, units_in_second](const Given& given) -> std::optional<std::string> {
    const auto number = finiteIn(given);
    const double found = number.value_or(0) / units_in_second;
    if (!number || found < lowest || found > highest) return isFound(given);
    value = fromSeconds(found);
    return std::nullopt;
  };
  kind.show = [&value, units_in_second] { return fmt::format("{}", toSeconds(value) * units_in_second); };
  return kind;
}

SettingKind durationOrNever(std::optional<Duration>& value, double lowest, double highest,
                            const std::string& unit, double units_in_second) {
  Duration unused{};
  SettingKind kind = duration(unused, lowest, highest, unit, units_in_second);
  kind.range += fmt::format(" {}; or {}: never", unit, kNever);
  kind.unit.clear();
  kind.take = [&value, lowest, highest, unit, units_in_second](const Given& given) {
    if (finiteIn(given) == kNever) {
      value.reset();
      return std::optional<std::string>();
    }
    Duration found{};
    auto fault = duration(found, lowest, highest, unit, units_in_second).take(given);
    if (!fault) value = found;
    return fault;
  };
  kind.show = [&value, units_in_second] {
    return fmt::format("{}", value ? toSeconds(*value) * units_in_second : kNever);
  };
  return kind;
}

}  // namespace

std::string isFound(const Given& given) {
  return "is " + describe(given);
}

std::optional<double> finiteIn(const Given& given) {
  const auto* whole = std::get_if<int>(&given.value);
  const auto* real = std::get_if<double>(&given.value);
  if (whole != nullptr) return static_cast<double>(*whole);
  return real != nullptr && std::isfinite(*real) ? std::optional(*real) : std::nullopt;
}

Result<std::vector<std::string>, std::string> textsIn(const Given& given) {
  const auto* list = std::get_if<GivenList>(&given.value);
  if (list == nullptr) return refuse(isFound(given));
  std::vector<std::string> texts;
  for (const Given& entry : *list) {
    const auto* one = std::get_if<std::string>(&entry.value);
    if (one == nullptr) return refuse("holds " + describe(entry));
    texts.push_back(*one);
  }
  return texts;
}

std::string enumerated(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

SettingKind flag(bool& value) {
  SettingKind kind;
  kind.form = Form::Flag;
  kind.type = "true or false";
  kind.take = [&value](const Given& given) -> std::optional<std::string> {
    const auto* found = std::get_if<bool>(&given.value);
    const auto* number = std::get_if<int>(&given.value);
    const bool is_digit = number != nullptr && (*number == 0 || *number == 1);
    if (found == nullptr && !is_digit) return isFound(given);
    value = found != nullptr ? *found : *number == 1;
    return std::nullopt;
  };
  kind.show = [&value] { return std::string(value ? "true" : "false"); };
  return kind;
}

SettingKind whole(int& value, int lowest, int highest, const std::string& unit) {
  SettingKind kind;
  kind.form = Form::Number;
  kind.type = "a whole number";
  kind.range = fmt::format("{} to {}", lowest, highest);
  kind.unit = unit;
  kind.take = [&value, lowest, highest](const Given& given) -> std::optional<std::string> {
    const auto* found = std::get_if<int>(&given.value);
    if (found == nullptr || *found < lowest || *found > highest) return isFound(given);
    value = *found;
    return std::nullopt;
  };
  kind.show = [&value] { return std::to_string(value); };
  return kind;
}

SettingKind port(int& value) {
  return whole(value, 0, 65535);
}

SettingKind real(double& value, double lowest, double highest, const std::string& unit) {
  return realIn(value, lowest, highest, unit, 1);
}

SettingKind realIn(double& value, double lowest, double highest, const std::string& unit,
                   double units_in_one) {
  SettingKind kind;
  kind.form = Form::Number;
  kind.type = "a number";
  kind.range = fmt::format("{} to {}", lowest, highest);
  kind.unit = unit;
  kind.take = [&value, lowest, highest, units_in_one](const Given& given) -> std::optional<std::string> {
    const auto found = finiteIn(given);
    if (!found || *found < lowest || *found > highest) return isFound(given);
    value = *found / units_in_one;
    return std::nullopt;
  };
  kind.show = [&value, units_in_one] { return fmt::format("{:.9g}", value * units_in_one); };
  return kind;
}

SettingKind seconds(Duration& value, double lowest, double highest) {
  SettingKind kind = duration(value, lowest, highest, "s", 1);
  kind.in_milliseconds = [&value, lowest, highest] { return duration(value, lowest, highest, "ms", 1000); };
  return kind;
}

SettingKind secondsOrNever(std::optional<Duration>& value, double lowest, double highest) {
  SettingKind kind = durationOrNever(value, lowest, highest, "s", 1);
  kind.in_milliseconds = [&value, lowest, highest] {
    return durationOrNever(value, lowest, highest, "ms", 1000);
  };
  return kind;
}

TextRule anyText() {
  return {"a text", [](const std::string&) { return true; }};
}

TextRule name(std::size_t longest) {
  return {fmt::format("a text of 1 to {} bytes without control characters", longest),
          [longest](const std::string& text) {
            return !text.empty() && text.size() <= longest && escaped(text) == text;
          }};
}

TextRule oneOf(const std::vector<std::string>& words) {
  return {enumerated(words), [words](const std::string& text) {
            return std::find(words.begin(), words.end(), text) != words.end();
          }};
}

TextRule orEmpty(TextRule rule) {
  return {rule.allowed + ", or empty",
          [holds = std::move(rule.holds)](const std::string& text) { return text.empty() || holds(text); }};
}

SettingKind text(std::string& value, const TextRule& rule) {
  const auto read = [rule](const std::string& found) -> Result<std::string, std::string> {
    if (!rule.holds(found)) return refuse(isFound({found}));
    return found;
  };
  return written<std::string>(value, rule.allowed, read, orEmptyShown);
}

SettingKind texts(std::vector<std::string>& value, const std::string& allowed) {
  SettingKind kind;
  kind.form = Form::Texts;
  kind.type = allowed;
  kind.take = [&value](const Given& given) -> std::optional<std::string> {
    auto found = textsIn(given);
    if (!found) return found.error();
    value = *std::move(found);
    return std::nullopt;
  };
  kind.show = [] { return std::string("none"); };
  return kind;
}

}  // namespace cobot_command::setting_kinds
