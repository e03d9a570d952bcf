#include "setting_options.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::tools {

namespace {

using Form = SettingKind::Form;

void take(const std::string& option, const SettingKind& kind, const Given& given) {
  if (const auto found = kind.take(given)) {
    throw CLI::ValidationError(option, describe(SettingFault{option, *found, allowedBy(kind)}));
  }
}

/// Both names take =true and =false besides; the last one counts.
void addFlag(CLI::App& app, const Setting& setting) {
  const bool is_on = isOn(setting);
  const std::string option = optionOf(setting);
  const std::string name = longOptionOf(setting);
  const std::string names = is_on ? '!' + option + ',' + name : option + (option == name ? "" : ',' + name);
  const std::string meaning = is_on ? "not: " + setting.meaning : setting.meaning;
  app.add_flag_function(
         names, [option, kind = setting.kind](std::int64_t count) { take(option, kind, {count > 0}); },
         meaning)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// The rule of one option; a list is made of several.
std::string allowedByOption(const SettingKind& kind) {
  constexpr std::string_view kList = "a list of ";
  std::string allowed = allowedBy(kind);
  if (kind.form != Form::Texts || allowed.compare(0, kList.size(), kList) != 0) return allowed;
  return allowed.substr(kList.size()) + "; can be given several times";
}

/// As CLI11 has them; all are read as texts, and taken by their kind.
std::string typeName(const SettingKind& kind) {
  int unused = 0;
  if (kind.form == Form::Number) {
    return kind.type == setting_kinds::whole(unused, 0, 0).type ? "INT" : "FLOAT";
  }
  return kind.form == Form::Numbers ? "FLOAT,..." : "TEXT";
}

void addValue(CLI::App& app, const Setting& setting) {
  const std::string option = optionOf(setting);
  const std::string name = longOptionOf(setting);
  const SettingKind kind = setting.kind.in_milliseconds ? setting.kind.in_milliseconds() : setting.kind;
  const bool is_repeated = kind.form == Form::Texts;
  auto* added = app.add_option_function<std::vector<std::string>>(
      option + (option == name ? "" : ',' + name),
      [option, kind](const std::vector<std::string>& words) {
        // CLI11 takes {} for a list of nothing.
        take(option, kind, givenBy(words.empty() ? std::vector<std::string>{"{}"} : words, kind.form));
      },
      fmt::format("{} ({})", setting.meaning, allowedByOption(kind)));
  added->type_size(1)->expected(1, is_repeated ? CLI::detail::expected_max_vector_size : 1);
  added->allow_extra_args(is_repeated);  // else it takes every stray word behind it
  added->type_name(typeName(kind));
  added->default_str(kind.show());
}

}  // namespace

void addOptions(CLI::App& app, const SettingTable& table) {
  for (const Setting& setting : table) {
    if (setting.kind.form == Form::Flag) {
      addFlag(app, setting);
    } else {
      addValue(app, setting);
    }
  }
}

CLI::ValidationError badUsage(const SettingTable& table, const SettingFault& fault) {
  std::string option = fault.setting;
  for (const Setting& setting : table) {
    if (setting.name == fault.setting) option = optionOf(setting);
  }
  return CLI::ValidationError(option, describe(fault));
}

}  // namespace cobot_command::tools
