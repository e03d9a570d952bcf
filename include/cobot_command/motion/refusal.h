// Why a motion is not made: named, with the first offending point.
#pragma once

#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::motion {

struct Refusal {
  enum class Reason {
    NotFinite,         ///< an input is NaN or infinite
    BadParameter,      ///< speed, time to top speed or angle out of range
    Unreachable,       ///< no posture reaches the point
    PoseBits,          ///< reachable, but not with the wanted pose bits
    JointLimit,        ///< a joint would leave its range
    JointSpeed,        ///< a joint would have to be faster than rated
    Singular,          ///< the path runs into or too close to a singularity
    DegenerateCircle,  ///< start, via and end do not define a circle
    AmbiguousTurn      ///< half a turn: either way round leads to the target (Setting::start_tolerance)
  };

  Reason reason = Reason::Unreachable;
  double at = 0.0;                          ///< where on the path, 0 (start) .. 1 (end)
  int joint = -1;                           ///< 0..5 where one joint is to blame, else -1
  arm::Pose point = arm::Pose::Identity();  ///< the first offending point: the TCP in the active base [m]
  std::string message;                      ///< found, allowed, what to do; mm and degrees, as on the pendant
};

/// "UNREACHABLE", "JOINT_LIMIT", ...
[[nodiscard]] const char* toString(Refusal::Reason reason);

}  // namespace cobot_command::motion
