// All settings of a simulated controller: one table for the options of tm_simulator, the parameters of
// simulated_controller_node and the documentation page.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::runtime {

struct SimulatorSetup {
  std::string robot_model;  ///< empty: the program chooses the model
  simulator::Settings settings;
  SimulatorOptions options;
  bool log_traffic = false;  ///< logs sent and received data, in words
};

/// A row for each setting, in the order of the pages; `setup` must outlive the table.
[[nodiscard]] SettingTable settingsTable(SimulatorSetup& setup);

/// Settings that contradict each other or the chosen model; nullopt: none.
[[nodiscard]] std::optional<SettingFault> faultIn(const SimulatorSetup& setup, const arm::ArmModel& arm);

}  // namespace cobot_command::runtime
