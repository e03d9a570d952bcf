// The words of a refused path: where it is, what was found, what is allowed, what to do.
#pragma once

#include <optional>

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

/// Where a path to joints ends in others. A path leads to a pose; that the joints are those of the target is
/// to be seen. `point`: the target, in the active base.
[[nodiscard]] std::optional<Refusal> otherPosture(const arm::JointVector& end, const arm::JointVector& target,
                                                  const arm::Pose& point);

}  // namespace cobot_command::motion
