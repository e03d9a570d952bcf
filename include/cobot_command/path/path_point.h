// A point of a path as received from a caller, unchecked: the structure of Rockwell's instruction LoadPath,
// in mm, degrees and %.
#pragma once

#include <array>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::path {

// Numbers of the fields. A received number may be any other.
enum class MoveType { Absolute = 0, Incremental = 1 };
enum class TargetType { Joint = 0, Cartesian = 1, Hybrid = 2 };
enum class Interpolation { Ptp = 0, Linear = 1, Wrist = 2, Circular = 3 };
enum class MovedFrame { Flange = 2, Tool = 3 };
enum class Reference { World = 0, Robot = 1, User = 4 };
enum class Termination { Stop = 0, Blend = 6 };
enum class ProfileType { SCurve = 0, Poly5 = 1, ModSine = 2, SineSquared = 3 };

/// True if the number of a field is that of `value`.
template <class Enum>
[[nodiscard]] constexpr bool is(int number, Enum value) {
  return number == static_cast<int>(value);
}

struct PathPoint {
  int move_id = 0;        ///< reported unchanged; 0: the number of the goal
  int move_type = 0;      ///< MoveType
  int target_type = 0;    ///< TargetType: how the target is specified, independent of the interpolation
  int interpolation = 0;  ///< Interpolation: shape of the motion
  /// Pose of the moved frame in the reference [mm, deg]; Hybrid: only x, y, z are used.
  arm::ControllerPose pose{};
  int pose_type = static_cast<int>(MovedFrame::Flange);  ///< MovedFrame: what moves to the pose, and straight
  int pose_id = 0;                                       ///< number of the tool
  int ref_frame_type = static_cast<int>(Reference::Robot);  ///< Reference
  int ref_frame_id = 0;                                     ///< number of the user frame
  /// J1..J6 [deg], the others 0; Hybrid: only J4..J6 are used.
  std::array<double, 9> joints{};
  arm::ControllerPose
      via_pose{};            ///< Circular: x, y, z of a point on the arc [mm], as `pose`; also as increments
  int termination_type = 0;  ///< Termination
  double command_tolerance = 0;  ///< Blend: PTP 0..100 % of the path, else >= 0 mm
  int robot_configuration = 0;   ///< bit 0: use bits 1..3 (lefty, above, flip)
  int profile_type = 0;          ///< ProfileType
  double speed = 0;              ///< PTP deg/s, else mm/s; 0: as the previous point of the same kind
  double acceleration = 0;       ///< deg/s^2 or mm/s^2
  double deceleration = 0;
  double acceleration_jerk = 0;  ///< 0..100 % of the ramp's time
  double deceleration_jerk = 0;
  double orientation_speed = 0;  ///< not PTP [deg/s]
  double orientation_acceleration = 0;
  double orientation_deceleration = 0;
  double tracking_axis_position = 0;  ///< [mm]
};

}  // namespace cobot_command::path
