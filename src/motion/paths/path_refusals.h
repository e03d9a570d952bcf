// The words of a refused path: where it is, what was found, what is allowed, what to do.
#pragma once

#include "paths/path_check.h"

namespace cobot_command::motion {

/// Where a joint would first be faster than rated, and what share of the asked top speed would do everywhere.
struct SpeedOffence {
  double progress = 0.0;
  int joint = 0;
  double needed = 0.0;  ///< [rad/s]
  double usable_share = 1.0;
};

/// `reason` is Unreachable or PoseBits.
[[nodiscard]] Refusal reachRefusal(const TimedPath& timed, double progress, Refusal::Reason reason);
[[nodiscard]] Refusal jointLimitRefusal(const TimedPath& timed, double progress, int joint, double found);
[[nodiscard]] Refusal singularRefusal(const TimedPath& timed, double progress,
                                      const arm::JointVector& joints);
[[nodiscard]] Refusal jointSpeedRefusal(const TimedPath& timed, const SpeedOffence& offence);

}  // namespace cobot_command::motion
