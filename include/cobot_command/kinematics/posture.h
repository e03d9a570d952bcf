// The posture of an arm, as the kinematics calculations report it: joints, pose bits and turns.
#pragma once

#include <array>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/pose_bits.h"

namespace cobot_command::kinematics {

/// For each joint: 0 in (-180, 180] degrees, 1 in (180, 540], -1 in (-540, -180], and so on.
using Turns = std::array<int, arm::kJointCount>;
[[nodiscard]] Turns turnsOf(const arm::ControllerJoints& joints_deg);

struct Posture {
  arm::ControllerJoints joints{};  ///< [deg]
  arm::PoseBits bits;              ///< at a singularity: doc/kinematics.md
  Turns turns{};
};

[[nodiscard]] Posture postureOf(const arm::JointVector& joints, const arm::PoseBits& bits);

/// Numbers in the tables; 0 is the flange or the robot base.
struct ToolAndFrame {
  int tool = 0;
  int frame = 0;
};

}  // namespace cobot_command::kinematics
