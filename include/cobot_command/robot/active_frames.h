// The base and the TCP that apply to the next command.
//
// They combine the values streamed by the controller and those commanded since. A change counts from its
// acceptance on, even while motions before it still run in the old frames.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::robot {

struct ActiveFrames {
  std::optional<arm::Pose> base;    ///< in the robot base [m]; nullopt: unknown
  std::string base_name;            ///< name in the project; empty: given by value, or unknown
  std::optional<arm::Pose> tcp;     ///< in the flange [m]; nullopt: unknown
  std::string tcp_name;             ///< name in the project; empty: given by value, or unknown
  std::optional<double> tool_mass;  ///< [kg]

  friend bool operator==(const ActiveFrames& a, const ActiveFrames& b);
  friend bool operator!=(const ActiveFrames& a, const ActiveFrames& b) { return !(a == b); }
};

}  // namespace cobot_command::robot
