// Parts of the goals of several blocks, in the units of the function blocks.
//
// Enumerations are integers as received from outside: any value may arrive, and the checks report the invalid
// ones.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::blocks {

/// Chosen by the caller; unique during the life of a core.
using GoalId = std::uint64_t;

/// x y z [mm] rx ry rz [deg], or J1..J6 [deg], depending on the data format.
using SixValues = std::array<double, 6>;

/// What happens to a goal that arrives while another command is Busy.
enum class BufferMode : int {
  Refuse = 0,    ///< the goal is refused (16#11), as in the thesis
  Buffered = 1,  ///< the goal is queued after all others
  Aborting = 2   ///< the robot is stopped, all others end as CommandAborted, then the goal runs
};

enum class Movement : int { Line = 0, Ptp = 1 };  ///< Table 5.3.2.4

/// Replacements for negative values of moves (SRCI: DefaultDynamics); nullopt: no default, and a negative
/// value is refused. Each is within the range of the goal's field.
struct DefaultDynamics {
  std::optional<double> speed_percent;
  std::optional<double> speed_mm_s;  ///< for formats with an absolute speed
  std::optional<double> accel_time;  ///< [ms]
  std::optional<double> blending_percent;
  std::optional<double> blending_mm;  ///< for formats with a radius

  friend bool operator==(const DefaultDynamics& a, const DefaultDynamics& b) {
    return a.speed_percent == b.speed_percent && a.speed_mm_s == b.speed_mm_s &&
           a.accel_time == b.accel_time && a.blending_percent == b.blending_percent &&
           a.blending_mm == b.blending_mm;
  }
};

/// A pose in any frame, as received from outside. It replaces the numbers of a function block.
struct FramedPose {
  std::string frame;                   ///< name given by the caller
  std::array<double, 3> position{};    ///< [m]
  std::array<double, 4> quaternion{};  ///< x y z w, of unit length
  /// The frame in the robot base; nullopt: it was not found, and `fault` gives the reason.
  std::optional<arm::Pose> frame_in_robot_base;
  std::string fault;
  /// The pose refers to the present place of the frame, not to its place at a given time: a goal that has
  /// waited is refused if the frame has moved.
  bool latest = false;
};

/// Present pose of a frame in the robot base; nullopt: not known, or no longer known. It must return at once,
/// because the core calls it while it works.
using FrameFinder = std::function<std::optional<arm::Pose>(const std::string& frame)>;

}  // namespace cobot_command::blocks
