#include "cobot_command/common/setting.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/nearest.h"

namespace cobot_command {

namespace {

/// All of the text, or nothing.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (text.empty() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

Given numberOrText(const std::string& word) {
  if (const auto whole = numberIn<int>(word)) return {*whole};
  if (const auto real = numberIn<double>(word)) return {*real};
  return {word};
}

Given numbersIn(const std::string& text) {
  GivenList list;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
    const std::size_t last = text.find_last_not_of(' ', end - 1);
    list.push_back(numberOrText(first < end ? text.substr(first, last + 1 - first) : std::string()));
    begin = end + 1;
  }
  return {list};
}

}  // namespace

std::string describe(const SettingFault& fault) {
  return forPeople(fmt::format("{}; allowed: {}", fault.found, fault.allowed));
}

std::string allowedBy(const SettingKind& kind) {
  const std::string unit = kind.unit.empty() ? "" : ' ' + kind.unit;
  return kind.type + (kind.range.empty() ? unit : ", " + kind.range + unit);
}

SettingTable joined(const std::vector<SettingTable>& tables) {
  SettingTable all;
  for (const SettingTable& table : tables) all.insert(all.end(), table.begin(), table.end());
  return all;
}

std::optional<SettingFault> take(const SettingTable& table, const GivenValues& values) {
  for (const Setting& setting : table) {
    const auto given = values.find(setting.name);
    if (given == values.end()) continue;
    if (auto found = setting.kind.take(given->second)) {
      return SettingFault{setting.name, *found, allowedBy(setting.kind)};
    }
  }
  return std::nullopt;
}

std::vector<UnknownSetting> unknownSettings(const SettingTable& table, const GivenValues& values) {
  std::vector<std::string> known;
  for (const Setting& setting : table) known.push_back(setting.name);
  std::vector<UnknownSetting> unknown;
  for (const auto& entry : values) {
    const std::string& name = entry.first;
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    unknown.push_back({name, nearestOf(name, known)});
  }
  return unknown;
}

bool isOn(const Setting& setting) {
  return setting.kind.form == SettingKind::Form::Flag && setting.kind.show() == "true";
}

std::string longOptionOf(const Setting& setting) {
  std::string name = setting.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string optionOf(const Setting& setting) {
  if (!setting.option.empty()) return "--" + setting.option;
  return isOn(setting) ? "--no-" + longOptionOf(setting).substr(2) : longOptionOf(setting);
}

Given givenBy(const std::vector<std::string>& words, SettingKind::Form form) {
  using Form = SettingKind::Form;
  const std::string word = words.empty() ? std::string() : words.back();
  switch (form) {
    case Form::Flag:
      return word == "true" || word == "false" ? Given{word == "true"} : numberOrText(word);
    case Form::Number:
      return numberOrText(word);
    case Form::Numbers:
      return numbersIn(word);
    case Form::Texts: {
      GivenList list;
      for (const std::string& text : words) list.push_back({text});
      return {list};
    }
    default:
      return {word};
  }
}

}  // namespace cobot_command
