// Options of the command line, made of a table of settings.
#pragma once

#include <CLI/CLI.hpp>

#include "cobot_command/common/setting.h"

namespace cobot_command::tools {

/// An option for each row, with durations in milliseconds. They set the variables that the rows are bound to;
/// what a row refuses is bad usage.
void addOptions(CLI::App& app, const SettingTable& table);

/// As the parser tells bad usage: the option, what was found, what is allowed.
[[nodiscard]] CLI::ValidationError badUsage(const SettingTable& table, const SettingFault& fault);

}  // namespace cobot_command::tools
