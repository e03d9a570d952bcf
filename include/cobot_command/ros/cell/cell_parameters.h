// The parameters by which a command node has a seat in a cell.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

/// `cell` is empty outside of cells.
struct CellParameters {
  std::string cell;      ///< the namespace of the supervisor
  std::string robot;     ///< its name in the cell
  std::string artifact;  ///< absolute path of the file that `tm_cell build` has written
};

/// A row for each; `parameters` outlives them.
[[nodiscard]] SettingTable cellRows(CellParameters& parameters);
/// What does not fit together.
[[nodiscard]] std::optional<SettingFault> faultIn(const CellParameters& parameters);

}  // namespace cobot_command::ros_adapter
