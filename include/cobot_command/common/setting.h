// Settings as rows of a table: a name, what it can be, what it means, and the variable that it sets.
//
// Programs make their options, parameters and pages from such tables, so that each setting stands in one
// place.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/common/given.h"

namespace cobot_command {

/// What is wrong with a setting: "script_port", "is 70000", "a whole number, 0 to 65535".
struct SettingFault {
  std::string setting;
  std::string found;
  std::string allowed;
};
/// "is 70000; allowed: a whole number, 0 to 65535"
[[nodiscard]] std::string describe(const SettingFault& fault);

/// What a setting can be, bound to the variable that holds it, which outlives it; see setting_kinds.h.
struct SettingKind {
  enum class Form { Flag, Number, Text, Numbers, Texts };  ///< what a command line makes of its words

  Form form = Form::Text;
  std::string type;   ///< "a whole number"
  std::string range;  ///< "0 to 65535"; empty: whatever is of the type
  std::string unit;   ///< of value and range: "s"; empty: none
  /// Takes the value; or says what was found ("is 70000"), and the variable stays as it is.
  std::function<std::optional<std::string>(const Given&)> take;
  /// The value as pages and helps show it.
  std::function<std::string()> show;
  /// The same in milliseconds, as command lines have durations; empty for what is none.
  std::function<SettingKind()> in_milliseconds;
};
/// "a whole number, 0 to 65535"
[[nodiscard]] std::string allowedBy(const SettingKind& kind);

struct Setting {
  std::string name;  ///< of the parameter; as an option it has hyphens
  SettingKind kind;
  std::string meaning;
  /// Another name of the option. Of a flag that is on it turns it off.
  std::string option = {};
};
using SettingTable = std::vector<Setting>;
/// One behind the other.
[[nodiscard]] SettingTable joined(const std::vector<SettingTable>& tables);
using GivenValues = std::map<std::string, Given>;

/// Sets what is given, row by row; the first fault ends it. Names without a row are passed over.
[[nodiscard]] std::optional<SettingFault> take(const SettingTable& table, const GivenValues& values);

/// Given, but in no row of the table.
struct UnknownSetting {
  std::string name;
  std::string meant;  ///< the nearest known name; empty when none is close
};
[[nodiscard]] std::vector<UnknownSetting> unknownSettings(const SettingTable& table,
                                                          const GivenValues& values);

/// The option on a command line: "--base" for bases; for a flag that is on the one that turns it off,
/// "--any-payload" or "--no-project-running".
[[nodiscard]] std::string optionOf(const Setting& setting);
/// The name as an option: "--bases".
[[nodiscard]] std::string longOptionOf(const Setting& setting);
/// Is it a flag that is on?
[[nodiscard]] bool isOn(const Setting& setting);

/// What an option with these words gives to a setting of that form: "5" is a number for one, a text for
/// another. Lists of numbers are written with commas.
[[nodiscard]] Given givenBy(const std::vector<std::string>& words, SettingKind::Form form);

}  // namespace cobot_command
