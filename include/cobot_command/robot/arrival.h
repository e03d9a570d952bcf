// Where a motion should leave the robot, and whether the status stream shows it there.
//
// A real arm is calibrated: with the same joint angles its tool is up to some millimetres from where the
// nominal model computes it (TM 4.1). So a joint target is compared joint by joint. A pose is compared with
// the TCP pose that the controller streams, which is that of its own, calibrated arm. A target planned as an
// offset from the robot's position contains the error of the model, so its tolerance is larger by that error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/link/robot_status.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::robot {

enum class TargetKind {
  Joints,
  Pose,
  Offset  ///< a Cartesian offset
};

struct Target {
  TargetKind kind = TargetKind::Joints;
  arm::JointVector joints;  ///< as planned [rad]
  arm::Pose tcp;            ///< in the flange [m]
  /// The target is at or next to the start of the motion: being there proves little.
  bool is_the_start = false;
};

/// Kind of target of the last motion in the list; nullopt: there is no motion, or a stop follows it.
[[nodiscard]] std::optional<TargetKind> targetKindOf(const std::vector<script::ScriptCommand>& commands);

/// Target of a last motion to joints: it is known even if the motion cannot be planned because the start or
/// the model is unknown.
[[nodiscard]] std::optional<Target> jointTargetOf(const std::vector<script::ScriptCommand>& commands);

struct ArrivalLimits {
  double position = 0;  ///< [m]
  double angle = 0;     ///< [rad]
};

struct Gap {
  bool closed = false;  ///< the robot is at the target
  std::string text;     ///< "J3 is 12.3 deg from its target"
};

/// Distance of the robot from the target; nullopt: the frame does not show it. Only joint targets can be
/// compared without a model (`arm`: nullptr).
[[nodiscard]] std::optional<Gap> gapTo(const Target& target, const link::RobotStatus& status,
                                       const arm::ArmModel* arm, const ArrivalLimits& limits);

}  // namespace cobot_command::robot
