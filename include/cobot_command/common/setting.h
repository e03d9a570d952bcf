// Settings as rows of a table: name, allowed values, meaning, and the variable to set.
//
// Programs generate their options, parameters and documentation pages from these tables, so each setting is
// defined in one place.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/common/given.h"

namespace cobot_command {

/// An invalid setting: "script_port", "is 70000", "a whole number, 0 to 65535".
struct SettingFault {
  std::string setting;
  std::string found;
  std::string allowed;
};
/// "is 70000; allowed: a whole number, 0 to 65535"
[[nodiscard]] std::string describe(const SettingFault& fault);

/// The allowed values of a setting, and the variable that stores it. The variable must outlive the kind. See
/// setting_kinds.h.
struct SettingKind {
  enum class Form { Flag, Number, Text, Numbers, Texts };  ///< how to interpret the words of an option

  Form form = Form::Text;
  std::string type;   ///< "a whole number"
  std::string range;  ///< "0 to 65535"; empty: every value of the type
  std::string unit;   ///< of value and range: "s"; empty: no unit
  /// Stores the value. On error it returns what was found ("is 70000"), and the variable is unchanged.
  std::function<std::optional<std::string>(const Given&)> take;
  /// The current value for documentation pages and help texts.
  std::function<std::string()> show;
  /// The same setting in milliseconds, the unit of durations on command lines; empty if it is not a duration.
  std::function<SettingKind()> in_milliseconds;
};
/// "a whole number, 0 to 65535"
[[nodiscard]] std::string allowedBy(const SettingKind& kind);

struct Setting {
  std::string name;  ///< of the parameter; the option has hyphens instead of underscores
  SettingKind kind;
  std::string meaning;
  /// Alternative name of the option. For a flag that is on by default this option switches it off.
  std::string option = {};
};
using SettingTable = std::vector<Setting>;
/// The tables concatenated.
[[nodiscard]] SettingTable joined(const std::vector<SettingTable>& tables);
using GivenValues = std::map<std::string, Given>;

/// Stores the given values row by row. The first fault ends it. Names without a row are ignored.
[[nodiscard]] std::optional<SettingFault> take(const SettingTable& table, const GivenValues& values);

/// A given name that is in no row of the table.
struct UnknownSetting {
  std::string name;
  std::string meant;  ///< the most similar known name; empty if none is close
};
[[nodiscard]] std::vector<UnknownSetting> unknownSettings(const SettingTable& table,
                                                          const GivenValues& values);

/// The option on a command line: "--base" for bases. For a flag that is on: the option that switches it off,
/// "--any-payload" or "--no-project-running".
[[nodiscard]] std::string optionOf(const Setting& setting);
/// The parameter name as an option: "--bases".
[[nodiscard]] std::string longOptionOf(const Setting& setting);
/// True for a flag whose current value is true.
[[nodiscard]] bool isOn(const Setting& setting);

/// Converts the words of an option to a value for a setting of that form: "5" is a number for one form, a
/// text for another. Lists of numbers are separated by commas.
[[nodiscard]] Given givenBy(const std::vector<std::string>& words, SettingKind::Form form);

}  // namespace cobot_command
