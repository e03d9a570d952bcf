// What goals of several blocks are made of, in the units of the function blocks.
//
// Enumerations are integers as they come from outside: any value may arrive, and the checks name the wrong
// ones.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::blocks {

/// Chosen by the caller, unique for the life of a core.
using GoalId = std::uint64_t;

/// x y z [mm] rx ry rz [deg], or J1..J6 [deg], as the data format says.
using SixValues = std::array<double, 6>;

/// What becomes of a goal that comes while another command is Busy.
enum class BufferMode : int {
  Refuse = 0,    ///< 16#11, as in the thesis
  Buffered = 1,  ///< waits its turn behind all others
  Aborting = 2   ///< stops the robot, ends all others as CommandAborted, then runs
};

enum class Movement : int { Line = 0, Ptp = 1 };  ///< Table 5.3.2.4

/// What moves have whose own value is negative (SRCI: DefaultDynamics); absent: there is none, and a negative
/// value is refused. Each within the range that the field of a goal has.
struct DefaultDynamics {
  std::optional<double> speed_percent;
  std::optional<double> speed_mm_s;  ///< of formats with an absolute speed
  std::optional<double> accel_time;  ///< [ms]
  std::optional<double> blending_percent;
  std::optional<double> blending_mm;  ///< of formats with a radius

  friend bool operator==(const DefaultDynamics& a, const DefaultDynamics& b) {
    return a.speed_percent == b.speed_percent && a.speed_mm_s == b.speed_mm_s &&
           a.accel_time == b.accel_time && a.blending_percent == b.blending_percent &&
           a.blending_mm == b.blending_mm;
  }
};

/// A pose in any frame, in place of the numbers of a function block; as it came from outside.
struct FramedPose {
  std::string frame;                   ///< as the caller named it
  std::array<double, 3> position{};    ///< [m]
  std::array<double, 4> quaternion{};  ///< x y z w, of unit length
  /// The frame in the robot base; absent when it could not be found, and then `fault` says why.
  std::optional<arm::Pose> frame_in_robot_base;
  std::string fault;
  /// Meant is where the frame is, and not where it was at some time: a goal that has waited is refused when
  /// it has moved.
  bool latest = false;
};

/// Where a frame is now, in the robot base; nothing when that is not known (any more). Has to answer at once:
/// the only thing that the core has to ask while it works.
using FrameFinder = std::function<std::optional<arm::Pose>(const std::string& frame)>;

}  // namespace cobot_command::blocks
