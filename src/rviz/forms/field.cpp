#include "forms/field.h"

#include <utility>

namespace cobot_command::rviz_plugin {
namespace {

Field named(Field::Kind kind, std::string key, std::string label) {
  Field field;
  field.kind = kind;
  field.key = std::move(key);
  field.label = std::move(label);
  return field;
}

}  // namespace

Field numberField(std::string key, std::string label, std::string unit, double lowest, double highest,
                  double number, int decimals) {
  Field field = named(Field::Kind::Number, std::move(key), std::move(label));
  field.unit = std::move(unit);
  field.lowest = lowest;
  field.highest = highest;
  field.decimals = decimals;
  field.number = number;
  return field;
}

Field choiceField(std::string key, std::string label, std::vector<Option> options, int value) {
  Field field = named(Field::Kind::Choice, std::move(key), std::move(label));
  field.options = std::move(options);
  field.number = value;
  return field;
}

Field switchField(std::string key, std::string label, bool on) {
  Field field = named(Field::Kind::Switch, std::move(key), std::move(label));
  field.highest = 1;
  field.number = on ? 1 : 0;
  return field;
}

Field textField(std::string key, std::string label, std::string text, std::string hint) {
  Field field = named(Field::Kind::Text, std::move(key), std::move(label));
  field.text = std::move(text);
  field.hint = std::move(hint);
  return field;
}

}  // namespace cobot_command::rviz_plugin
