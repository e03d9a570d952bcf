// How long a motion takes from rest to its top speed, whatever the script says of it.
#pragma once

#include "cobot_command/common/time.h"

namespace cobot_command::motion {

/// The rated acceleration of joints and TCP takes them from rest to their full speed, 100 %, in this time
/// [s]. Ours, as no source has it: the shortest time to top speed that the function blocks take.
inline constexpr double kRatedRamp = 0.15;

/// In s. A time of zero is the shortest ramp that the rated acceleration allows; `share`: the top speed as a
/// share of the full one, above 0.
[[nodiscard]] inline double rampTime(Duration time_to_top_speed, double share) {
  return time_to_top_speed == Duration::zero() ? share * kRatedRamp : toSeconds(time_to_top_speed);
}

}  // namespace cobot_command::motion
