#include "cobot_command/ros/cell/cell_parameters.h"

#include "shared/name_rules.h"

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command::ros_adapter {

using namespace setting_kinds;

SettingTable cellRows(CellParameters& p) {
  return {{"cell", text(p.cell, orEmpty(absoluteNamespace())),
           "namespace of the cell supervisor; empty: the robot is not in a cell. In a cell only "
           "`run_program` moves the robot"},
          {"cell_robot", text(p.robot), "name of the robot in the cell"},
          {"cell_artifact", text(p.artifact, orEmpty(absolutePath())),
           "file made by `tm_cell build`; the same file as the supervisor's"}};
}

std::optional<SettingFault> faultIn(const CellParameters& p) {
  if (p.cell.empty()) return std::nullopt;
  if (p.robot.empty()) {
    return SettingFault{"cell_robot", "is empty", "the name of a robot of the cell, because cell is set"};
  }
  if (!p.artifact.empty()) return std::nullopt;
  return SettingFault{"cell_artifact", "is empty", "an absolute path, because cell is set"};
}

}  // namespace cobot_command::ros_adapter
