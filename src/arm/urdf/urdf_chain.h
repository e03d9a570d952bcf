// From the text of a URDF to the six-joint chain base -> flange_link, whatever the geometry.
#pragma once

#include <array>
#include <string>

#include <kdl/chain.hpp>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

struct UrdfChain {
  std::string robot_name;
  std::array<std::string, kJointCount> joint_names;
  std::array<JointLimit, kJointCount> limits;
  KDL::Chain chain;
};

/// Finds the six joints by the ends of their names, so that a prefix ("left_shoulder_1_joint") does not
/// matter.
[[nodiscard]] Result<UrdfChain, ModelError> readUrdfChain(const std::string& urdf);

}  // namespace cobot_command::arm
