// Where a point leads: its numbers, with what came before it, in the robot base.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/path/path_point.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_scene.h"

namespace cobot_command::path {

/// Where the point before leads, also when it is blended past.
struct Previous {
  /// Its pose as it was written; increments are added to these numbers.
  struct Written {
    std::array<int, 4> frames{};  ///< moved frame and reference, type and number
    arm::ControllerPose numbers{};
  };

  arm::JointVector joints;  ///< [rad]
  std::optional<Written> written{};
};

/// A place of the moved frame's origin, and J4..J6.
struct HybridTarget {
  Eigen::Vector3d origin;  ///< in the robot base [m]
  Eigen::Vector3d wrist;   ///< [rad]
};

struct Target {
  std::variant<arm::JointVector, arm::Pose, HybridTarget> place;  ///< joints [rad], or the moved frame
  arm::Pose moved_frame = arm::Pose::Identity();                  ///< in the flange [m]
  Eigen::Vector3d via = Eigen::Vector3d::Zero();                  ///< of an arc, in the robot base [m]
  std::optional<Previous::Written> written{};
};

/// 1040 to 1042 when a frame is not known.
[[nodiscard]] Result<Target, PathRefusal> targetOf(const PathPoint& point, int index,
                                                   const Previous& previous, const PathScene& scene);

/// Its numbers mean another place when the world is elsewhere.
[[nodiscard]] bool isInWorld(const Previous::Written& written);

/// The posture that the point asks for; nothing: that of the target before it.
[[nodiscard]] std::optional<arm::PoseBits> askedBits(const PathPoint& point);
/// 1026: a hybrid target whose flip does not go with the sign of its J5 [rad].
[[nodiscard]] std::optional<PathRefusal> checkFlip(const PathPoint& point, int index, double j5);

}  // namespace cobot_command::path
