// Tables of settings as the pages show them.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "source_tree.h"

#include "cobot_command/common/setting.h"

namespace cobot_command::test_support {

inline std::string withUnit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit.front() == '[' ? text : text + ' ' + unit;
}

/// "| `~stop_time` | `--stop-time` [ms] | 0.2 s | 0 to 60 s | ... |"; without the options when told so.
inline std::string rowOf(const Setting& setting, bool has_options) {
  const SettingKind& kind = setting.kind;
  const std::string unit = kind.in_milliseconds ? " [ms]" : "";
  const std::string option = has_options ? " `" + optionOf(setting) + '`' + unit + " |" : "";
  const std::string values = kind.range.empty() ? allowedBy(kind) : withUnit(kind.range, kind.unit);
  return "| `~" + setting.name + "` |" + option + ' ' + withUnit(kind.show(), kind.unit) + " | " + values +
         " | " + setting.meaning + " |\n";
}

inline std::string tableOf(const SettingTable& settings, bool has_options) {
  std::string table = has_options
                          ? "| parameter | option | default | values | meaning |\n|---|---|---|---|---|\n"
                          : "| parameter | default | values | meaning |\n|---|---|---|---|\n";
  for (const Setting& setting : settings) table += rowOf(setting, has_options);
  return table;
}

inline std::string pageAt(const std::string& path) {
  std::ifstream file(inSourceTree(path));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace cobot_command::test_support
