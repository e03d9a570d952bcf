// What the controller's project has of the entries of our tables that it knows by name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/robot/read_ledger.h"
#include "cobot_command/script/project_attributes.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::command {

struct ProjectValues {
  std::map<std::string, arm::Pose> tcps;   ///< in the flange
  std::map<std::string, arm::Pose> bases;  ///< in the robot base
  std::map<std::string, tables::Load>
      burdens;  ///< what TCPs weigh, with the centre in the TCP, not the flange
};

/// What has to be read to compare all of them; a name that cannot stand in a script is left out.
[[nodiscard]] std::vector<script::AttributeRead> readsOf(const tables::Entries& entries);
/// `values`: of readsOf(), in any order.
[[nodiscard]] ProjectValues valuesOf(const std::vector<robot::ReadValue>& values);

// --- The way back: what makes the project have these.
[[nodiscard]] script::AttributeWrite tcpWrite(const std::string& name, const arm::Pose& in_flange);
[[nodiscard]] script::AttributeWrite baseWrite(const std::string& name, const arm::Pose& in_robot_base);
/// `tcp`: where that TCP is in the flange.
[[nodiscard]] std::vector<script::AttributeWrite> burdenWrites(const std::string& name,
                                                               const tables::Load& load,
                                                               const arm::Pose& tcp);

}  // namespace cobot_command::command
