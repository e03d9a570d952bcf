// How an arm stands, as callers of the kinematics see it: joints, pose bits and turns.
#pragma once

#include <array>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/pose_bits.h"

namespace cobot_command::kinematics {

/// Of each joint: 0 in (-180, 180] degrees, 1 in (180, 540], -1 in (-540, -180], and so on.
using Turns = std::array<int, arm::kJointCount>;
[[nodiscard]] Turns turnsOf(const arm::ControllerJoints& joints_deg);

struct Posture {
  arm::ControllerJoints joints{};  ///< [deg]
  arm::PoseBits bits;              ///< on a singularity: doc/kinematics.md
  Turns turns{};
};

[[nodiscard]] Posture postureOf(const arm::JointVector& joints, const arm::PoseBits& bits);

/// By their numbers in the tables; 0 is the flange, and the robot base.
struct ToolAndFrame {
  int tool = 0;
  int frame = 0;
};

}  // namespace cobot_command::kinematics
