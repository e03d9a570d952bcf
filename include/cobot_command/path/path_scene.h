// What a path is planned in: the arm, where it begins, and what its numbers of tools and frames mean.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::path {

struct PathScene {
  arm::ArmModel arm;
  arm::JointVector start;            ///< where the robot stands [rad]
  tables::DataTables tables{};       ///< of tools and frames
  std::optional<arm::Pose> world{};  ///< in the robot base [m]; nothing: nobody knows where it is
  double feedrate = 1.0;             ///< (0..1.25]: as much faster as time runs
};

}  // namespace cobot_command::path
