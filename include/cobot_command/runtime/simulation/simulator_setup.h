// All that a program can be told of a simulated controller: one table for the options of tm_simulator, the
// parameters of simulated_controller_node and the page.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::runtime {

struct SimulatorSetup {
  std::string robot_model;  ///< empty: whatever the program chooses then
  simulator::Settings settings;
  SimulatorOptions options;
  bool log_traffic = false;  ///< what is sent and received, in words
};

/// A row for each setting, in the order of the pages; `setup` outlives it.
[[nodiscard]] SettingTable settingsTable(SimulatorSetup& setup);

/// What does not fit together, or not to the model that was chosen.
[[nodiscard]] std::optional<SettingFault> faultIn(const SimulatorSetup& setup, const arm::ArmModel& arm);

}  // namespace cobot_command::runtime
