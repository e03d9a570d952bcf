// Poses and joints in the notation of the controller (mm and degrees), and their conversion to SI.
//
// R = Rz(RZ) Ry(RY) Rx(RX): fixed axes X, Y, Z (TM 4.3). Angles are returned in (-180, 180]; at RY = +-90
// degrees RZ is returned as 0.
#pragma once

#include <array>

#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// X, Y, Z [mm], RX, RY, RZ [deg].
using ControllerPose = std::array<double, 6>;
/// J1..J6 [deg].
using ControllerJoints = std::array<double, 6>;
/// The largest coordinate that is accepted [mm, deg].
inline constexpr double kMaxCoordinate = 100000;

[[nodiscard]] Pose toPose(const ControllerPose& pose_mm_deg);
[[nodiscard]] ControllerPose toControllerPose(const Pose& pose);
[[nodiscard]] JointVector toJointVector(const ControllerJoints& joints_deg);
[[nodiscard]] ControllerJoints toControllerJoints(const JointVector& joints);

/// The numbers as written in scripts, rounded to millionths: what a controller reads, and identical on every
/// machine, although sines and roots differ in the last digits.
[[nodiscard]] std::array<double, 6> asWritten(const std::array<double, 6>& values);

/// Equal within the resolution of the 32-bit floats of a status stream (mm and degrees): 0.1 mm, 0.1 mrad.
[[nodiscard]] bool isSamePose(const Pose& a, const Pose& b);

}  // namespace cobot_command::arm
