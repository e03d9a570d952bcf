// Why a motion is refused: the reason and the first offending point.
#pragma once

#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::motion {

struct Refusal {
  enum class Reason {
    NotFinite,         ///< an input is NaN or infinite
    BadParameter,      ///< speed, time to top speed or angle out of range
    Unreachable,       ///< no posture reaches the point
    PoseBits,          ///< reachable, but not with the requested pose bits
    JointLimit,        ///< a joint would leave its range
    JointSpeed,        ///< a joint would exceed its rated speed
    Singular,          ///< the path runs into a singularity or too close to one
    DegenerateCircle,  ///< start, via and end do not define a circle
    AmbiguousTurn      ///< half a turn: both directions lead to the target (Setting::start_tolerance)
  };

  Reason reason = Reason::Unreachable;
  double at = 0.0;                          ///< position on the path, 0 (start) .. 1 (end)
  int joint = -1;                           ///< 0..5 if one joint is the cause, else -1
  arm::Pose point = arm::Pose::Identity();  ///< the first offending point: the TCP in the active base [m]
  std::string message;  ///< found, allowed, what to do; in mm and degrees, as on the pendant
};

/// "UNREACHABLE", "JOINT_LIMIT", ...
[[nodiscard]] const char* toString(Refusal::Reason reason);

}  // namespace cobot_command::motion
