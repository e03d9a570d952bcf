// The environment of path planning: the arm, the start of the path, and the tables that tool and frame
// numbers refer to.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::path {

struct PathScene {
  arm::ArmModel arm;
  arm::JointVector start;            ///< posture of the robot [rad]
  tables::DataTables tables{};       ///< of tools and frames
  std::optional<arm::Pose> world{};  ///< in the robot base [m]; std::nullopt: unknown
  double feedrate = 1.0;             ///< (0..1.25]: time scale of the path
};

}  // namespace cobot_command::path
