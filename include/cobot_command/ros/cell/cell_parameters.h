// The parameters that make a command node a member of a cell.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

/// `cell` is empty if the node belongs to no cell.
struct CellParameters {
  std::string cell;   ///< the namespace of the supervisor
  std::string robot;  ///< the robot's name in the cell
  /// Absolute path of the file written by `tm_cell build`.
  std::string artifact;
};

/// A row for each parameter; `parameters` must outlive the table.
[[nodiscard]] SettingTable cellRows(CellParameters& parameters);
/// Parameters that contradict each other; nullopt: none.
[[nodiscard]] std::optional<SettingFault> faultIn(const CellParameters& parameters);

}  // namespace cobot_command::ros_adapter
