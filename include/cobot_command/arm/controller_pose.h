// Poses and joints as the controller writes them (mm and degrees), and their conversion to SI.
//
// R = Rz(RZ) Ry(RY) Rx(RX): fixed axes X, Y, Z (TM 4.3). Angles are reported in (-180, 180]; at RY =
// +-90 degrees RZ is reported as 0.
#pragma once

#include <array>

#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// X, Y, Z [mm], RX, RY, RZ [deg].
using ControllerPose = std::array<double, 6>;
/// J1..J6 [deg].
using ControllerJoints = std::array<double, 6>;
/// The largest coordinate [mm, deg] that is taken for one.
inline constexpr double kMaxCoordinate = 100000;

[[nodiscard]] Pose toPose(const ControllerPose& pose_mm_deg);
[[nodiscard]] ControllerPose toControllerPose(const Pose& pose);
[[nodiscard]] JointVector toJointVector(const ControllerJoints& joints_deg);
[[nodiscard]] ControllerJoints toControllerJoints(const JointVector& joints);

/// As scripts have numbers, to millionths: what a controller reads, and the same on every machine, though
/// sines and roots differ in their last digits.
[[nodiscard]] std::array<double, 6> asWritten(const std::array<double, 6>& values);

/// Equal as far as the 32-bit floats of mm and degrees of a status stream can tell: to 0.1 mm, 0.1 mrad.
[[nodiscard]] bool isSamePose(const Pose& a, const Pose& b);

}  // namespace cobot_command::arm
