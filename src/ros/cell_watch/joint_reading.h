// What a JointState of a robot of the family says, whatever else is in it.
#pragma once

#include <optional>
#include <string>

#include <sensor_msgs/JointState.h>

#include "cobot_command/arm/types.h"

namespace cobot_command::ros_adapter {

struct JointReading {
  arm::JointVector joints;                     ///< [rad]
  std::optional<arm::JointVector> velocities;  ///< [rad/s]
  std::string prefix;                          ///< of the names of joints and frames
};

/// The six joints of one robot by their names, in any order, among others. Nothing, where not all are there
/// exactly once, with one prefix, and each with a position. Numbers may be anything.
[[nodiscard]] std::optional<JointReading> readJoints(const sensor_msgs::JointState& message);

}  // namespace cobot_command::ros_adapter
