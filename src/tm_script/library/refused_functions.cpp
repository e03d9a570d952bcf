#include "library/refused_functions.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

/// By name, and by how a whole family begins (I848-E-03 and -04, chapters 2 to 6, 8, 9 and 11).
constexpr std::array<std::string_view, 6> kNames{"random",      "GetNow",  "GetNowStamp",
                                                 "GetVarValue", "VarSync", "intercoord"};
constexpr std::array<std::string_view, 10> kFamilies{"File_",     "com_", "socket_", "modbus_", "svr_",
                                                     "profinet_", "eip_", "Vision_", "Force_",  "TouchStop_"};
/// Functions of TMscript, the programs of TMflow 2.
constexpr std::array<std::string_view, 16> kOfPrograms{
    "Sleep",      "WaitFor", "Exit",    "Display", "ScriptListen", "ThreadRun", "ThreadID", "ThreadState",
    "ThreadExit", "sum",     "average", "stdevp",  "stdevs",       "min",       "max",      "CheckQueueTag"};

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string whyUnknown(std::string_view name) {
  const auto begins = [&](std::string_view family) { return name.substr(0, family.size()) == family; };
  if (has(kNames, name) || std::any_of(kFamilies.begin(), kFamilies.end(), begins)) {
    return fmt::format("{} is a known function, but not simulated", name);
  }
  if (has(kOfPrograms, name)) {
    return fmt::format("{} is a function of the programs of TMflow 2, not simulated", name);
  }
  return fmt::format("there is no function {}", name);
}

}  // namespace cobot_command::tm_script
