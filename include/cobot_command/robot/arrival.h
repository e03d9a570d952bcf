// Where a motion should leave the robot, and whether the status stream shows it there.
//
// A real arm is calibrated: the same joints put its tool up to some millimetres from where the nominal model
// has it (TM 4.1). So a joint target is compared joint by joint, a pose with the pose of the TCP that
// the controller streams, which is that of its own, calibrated arm. What was planned as an offset from where
// the robot stood has the error of the model in it, and is compared with as much more tolerance.
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
  Offset  ///< a Cartesian one
};

struct Target {
  TargetKind kind = TargetKind::Joints;
  arm::JointVector joints;    ///< as planned [rad]
  arm::Pose tcp;              ///< in the flange [m]
  bool is_the_start = false;  ///< it ends where it began, or next to it: to be there says little
};

/// Of the last motion among them; nothing when there is none, or a stop behind it.
[[nodiscard]] std::optional<TargetKind> targetKindOf(const std::vector<script::ScriptCommand>& commands);

/// Of a last motion to joints: that is known also where it cannot be planned, for want of a start or a model.
[[nodiscard]] std::optional<Target> jointTargetOf(const std::vector<script::ScriptCommand>& commands);

struct ArrivalLimits {
  double position = 0;  ///< [m]
  double angle = 0;     ///< [rad]
};

struct Gap {
  bool closed = false;  ///< the robot is at the target
  std::string text;     ///< "J3 is 12.3 deg from its target"
};

/// How far the robot is from the target; nothing when the frame does not tell it. Only joints need no model
/// (`arm`: nullptr).
[[nodiscard]] std::optional<Gap> gapTo(const Target& target, const link::RobotStatus& status,
                                       const arm::ArmModel* arm, const ArrivalLimits& limits);

}  // namespace cobot_command::robot
