// The base and the TCP that the next command is taken in.
//
// What the controller streams, and what was commanded since: a change counts from its acceptance on, even
// while motions in front of it still run in the old frames.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::robot {

struct ActiveFrames {
  std::optional<arm::Pose> base;    ///< in the robot base [m]; absent: unknown
  std::string base_name;            ///< of the project; empty: given by value, or unknown
  std::optional<arm::Pose> tcp;     ///< in the flange [m]; absent: unknown
  std::string tcp_name;             ///< of the project; empty: given by value, or unknown
  std::optional<double> tool_mass;  ///< [kg]

  friend bool operator==(const ActiveFrames& a, const ActiveFrames& b);
  friend bool operator!=(const ActiveFrames& a, const ActiveFrames& b) { return !(a == b); }
};

}  // namespace cobot_command::robot
