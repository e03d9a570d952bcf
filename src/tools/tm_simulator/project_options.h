// What the simulated project holds, on the command line: bases, TCPs, points and variables.
#pragma once

#include <CLI/CLI.hpp>

#include "cobot_command/simulator/settings.h"

namespace cobot_command::tools {

/// Adds the options; they change the settings, which outlive the parsing.
void describeProject(CLI::App& app, simulator::Settings& settings);

}  // namespace cobot_command::tools
