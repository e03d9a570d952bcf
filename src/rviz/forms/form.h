// What an operator enters for one command: fields, how they hang together, and presets. Neither widgets nor
// messages.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "forms/field.h"

namespace cobot_command::rviz_plugin {

/// Values that a button puts in all at once; fields that it does not name stay as they are.
struct Preset {
  std::string name;
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
};

class Form {
 public:
  /// Says which fields are shown and which options they have, by what the fields are. Called after each
  /// change.
  using Rule = std::function<void(Form&)>;

  explicit Form(std::vector<Field> fields, Rule rule = nullptr, std::vector<Preset> presets = {});

  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }
  [[nodiscard]] const std::vector<Preset>& presets() const { return presets_; }
  [[nodiscard]] bool has(const std::string& key) const { return places_.count(key) != 0; }
  /// Precondition of all that takes a key: there is such a field.
  [[nodiscard]] const Field& field(const std::string& key) const;

  [[nodiscard]] double number(const std::string& key) const { return field(key).number; }
  [[nodiscard]] int whole(const std::string& key) const;
  [[nodiscard]] bool isOn(const std::string& key) const { return field(key).number != 0; }
  [[nodiscard]] const std::string& text(const std::string& key) const { return field(key).text; }
  /// Of the fields `prefix`.0 to `prefix`.5, as addPose() and addJoints() make them.
  [[nodiscard]] std::array<double, 6> six(const std::string& prefix) const;

  /// False, and nothing is changed: what was given is out of the range of the field, no option of it, or too
  /// long.
  bool set(const std::string& key, double number);
  bool set(const std::string& key, const std::string& text);
  bool setSix(const std::string& prefix, const std::array<double, 6>& numbers);
  void apply(const Preset& preset);

  /// For a Rule.
  void show(const std::string& key, bool shown);
  void showGroup(const std::string& group, bool shown);
  /// An option that is gone and was chosen gives way to the first that is there.
  void offer(const std::string& key, std::vector<Option> options);

  /// All values by their keys; what was saved, as far as it still can be so: the rest stays as it is.
  [[nodiscard]] std::map<std::string, std::string> saved() const;
  void restore(const std::map<std::string, std::string>& values);

 private:
  Field& at(const std::string& key);
  bool put(const std::string& key, double number);
  void ruleAgain();

  std::vector<Field> fields_;
  std::map<std::string, std::size_t> places_;
  Rule rule_;
  std::vector<Preset> presets_;
};

/// x, y, z, rx, ry, rz of a pose: `prefix`.0 to `prefix`.5, in -100000..100000 mm and degrees.
void addPose(std::vector<Field>& fields, const std::string& prefix, const std::string& group);
/// The same of J1 to J6, in degrees, one turn and a half to each side.
void addJoints(std::vector<Field>& fields, const std::string& prefix, const std::string& group);

}  // namespace cobot_command::rviz_plugin
