// The parameters of the tables of tools, frames and loads: lists for the first start, and a file that stores
// written entries.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/tables/table_text.h"

namespace cobot_command::ros_adapter {

struct TableParameters {
  tables::TableLists lists;
  std::string file;           ///< empty: nothing is stored
  tables::DataTables tables;  ///< the resulting tables
};

/// A row for each parameter; `parameters` must outlive the table.
[[nodiscard]] SettingTable tableRows(TableParameters& parameters);

/// Reads the tables from the file, or from the lists if the file does not exist yet. `arm`: nullptr without a
/// model.
[[nodiscard]] std::optional<SettingFault> readTables(TableParameters& parameters, const arm::ArmModel* arm,
                                                     std::vector<std::string>& warnings);

}  // namespace cobot_command::ros_adapter
