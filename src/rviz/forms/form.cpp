#include "forms/form.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::rviz_plugin {
namespace {

/// Both of the layer itself (Transformation.msg), and of no use further off.
constexpr double kFarthest = 100000;
constexpr double kMostTurned = 540;

bool takes(const Field& field, double number) {
  if (!std::isfinite(number)) return false;
  if (field.kind == Field::Kind::Choice) {
    return std::any_of(field.options.begin(), field.options.end(),
                       [&](const Option& option) { return option.value == number; });
  }
  if (field.kind == Field::Kind::Text) return false;
  return number >= field.lowest && number <= field.highest;
}

std::string keyOf(const std::string& prefix, std::size_t index) {
  return fmt::format("{}.{}", prefix, index);
}

}  // namespace

Form::Form(std::vector<Field> fields, Rule rule, std::vector<Preset> presets)
    : fields_(std::move(fields)), rule_(std::move(rule)), presets_(std::move(presets)) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    [[maybe_unused]] const bool added = places_.emplace(fields_[i].key, i).second;
    assert(added);
  }
  ruleAgain();
}

const Field& Form::field(const std::string& key) const {
  const auto place = places_.find(key);
  assert(place != places_.end());
  return fields_[place->second];
}

Field& Form::at(const std::string& key) {
  return const_cast<Field&>(std::as_const(*this).field(key));
}

int Form::whole(const std::string& key) const {
  return static_cast<int>(std::lround(number(key)));
}

std::array<double, 6> Form::six(const std::string& prefix) const {
  std::array<double, 6> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number(keyOf(prefix, i));
  return numbers;
}

bool Form::put(const std::string& key, double number) {
  Field& field = at(key);
  if (!takes(field, number)) return false;
  field.number = number;
  return true;
}

bool Form::set(const std::string& key, double number) {
  if (!put(key, number)) return false;
  ruleAgain();
  return true;
}

bool Form::set(const std::string& key, const std::string& text) {
  Field& field = at(key);
  if (field.kind != Field::Kind::Text || text.size() > field.longest) return false;
  field.text = text;
  ruleAgain();
  return true;
}

bool Form::setSix(const std::string& prefix, const std::array<double, 6>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!takes(field(keyOf(prefix, i)), numbers[i])) return false;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) put(keyOf(prefix, i), numbers[i]);
  ruleAgain();
  return true;
}

void Form::apply(const Preset& preset) {
  // In the order of the fields: those further down may be options of those above.
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const std::string key = fields_[i].key;
    if (const auto number = preset.numbers.find(key); number != preset.numbers.end()) {
      set(key, number->second);
    }
    if (const auto text = preset.texts.find(key); text != preset.texts.end()) set(key, text->second);
  }
}

void Form::show(const std::string& key, bool shown) {
  at(key).shown = shown;
}

void Form::showGroup(const std::string& group, bool shown) {
  for (Field& field : fields_) {
    if (field.group == group) field.shown = shown;
  }
}

void Form::offer(const std::string& key, std::vector<Option> options) {
  Field& field = at(key);
  field.options = std::move(options);
  if (!takes(field, field.number)) field.number = field.options.front().value;
}

std::map<std::string, std::string> Form::saved() const {
  std::map<std::string, std::string> values;
  for (const Field& field : fields_) {
    values[field.key] = field.kind == Field::Kind::Text ? field.text : fmt::format("{}", field.number);
  }
  return values;
}

void Form::restore(const std::map<std::string, std::string>& values) {
  // As in apply().
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const auto value = values.find(fields_[i].key);
    if (value == values.end()) continue;
    if (fields_[i].kind == Field::Kind::Text) {
      set(value->first, value->second);
      continue;
    }
    // Not strtod: the point of what was saved is none to it where numbers have a comma.
    double number = 0;
    const char* const end = value->second.data() + value->second.size();
    const auto read = std::from_chars(value->second.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end) set(value->first, number);
  }
}

void Form::ruleAgain() {
  if (rule_) rule_(*this);
}

void addPose(std::vector<Field>& fields, const std::string& prefix, const std::string& group) {
  constexpr std::array kLabels{"X", "Y", "Z", "RX", "RY", "RZ"};
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    Field field = numberField(keyOf(prefix, i), kLabels[i], i < 3 ? "mm" : "°", -kFarthest, kFarthest, 0, 3);
    field.group = group;
    fields.push_back(std::move(field));
  }
}

void addJoints(std::vector<Field>& fields, const std::string& prefix, const std::string& group) {
  for (std::size_t i = 0; i < 6; ++i) {
    Field field =
        numberField(keyOf(prefix, i), fmt::format("J{}", i + 1), "°", -kMostTurned, kMostTurned, 0, 3);
    field.group = group;
    fields.push_back(std::move(field));
  }
}

}  // namespace cobot_command::rviz_plugin
