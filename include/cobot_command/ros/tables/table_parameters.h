// The parameters of the tables of tools, frames and loads: lists for the first start, and a file that keeps
// what is written.
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
  std::string file;           ///< empty: nothing is kept
  tables::DataTables tables;  ///< what they come to
};

/// A row for each; `parameters` outlives it.
[[nodiscard]] SettingTable tableRows(TableParameters& parameters);

/// The tables of the file, or, where there is none yet, of the lists. `arm`: nullptr without a model.
[[nodiscard]] std::optional<SettingFault> readTables(TableParameters& parameters, const arm::ArmModel* arm,
                                                     std::vector<std::string>& warnings);

}  // namespace cobot_command::ros_adapter
