// Whether an arm can follow a timed TCP path: every sample, before the motion starts.
#pragma once

#include <vector>

#include "paths/path_postures.h"
#include "profiles/profile.h"

#include "cobot_command/motion/command.h"

namespace cobot_command::motion {

/// Samples are at most this far apart [s], unless the TCP goes so slowly that they are close together on its
/// way all the same.
inline constexpr double kSamplePeriod = 1e-3;
/// As far as it may go between two samples then, at its top speed (sum of m and rad): a quarter of what a
/// fast one goes in kSamplePeriod. And the longest period [s], as ramps are not to fall between two samples.
inline constexpr double kSampleWay = 0.25e-3;
inline constexpr double kLongestSamplePeriod = 16e-3;

/// A posture is singular where one of arm::SingularityDistance is below this [m or 1]: 2.5 mm, 0.14 degrees.
/// No joint and no TCP gets from here onto the singularity within half a sample, so no exit from the reach
/// hides between two samples.
inline constexpr double kSingular = 2.5e-3;

/// A step of a joint between two samples that calls for a closer look [rad].
inline constexpr double kJump = 0.1;
/// A jump over so short a way (sum of m and rad) is a jump whatever the speed: the path runs through a
/// singularity.
inline constexpr double kJumpWay = 1e-7;

/// Room for the mean speed of a step to differ from the speed at its ends.
inline constexpr double kSpeedTolerance = 1e-3;

/// A speed as it was asked for: for messages.
struct AskedSpeed {
  double value = 0.0;          ///< in its unit
  const char* unit = nullptr;  ///< "%", "mm/s"; nullptr: the times were asked for
  const char* otherwise = "";  ///< what to do where no useful one is slow enough
};

struct TimedPath {
  const PathPostures& postures;
  const Profile& profile;
  const char* name;  ///< "line", "circle": for messages
  const AskedSpeed& speed;
  const arm::Pose& base;  ///< the active base in the robot base: for messages
};

/// What the check saw on the way.
struct FollowedPath {
  std::vector<arm::JointVector> postures;  ///< at the start, then every `period`
  double period = 0.0;                     ///< [s]
  arm::JointVector end;
};

/// Follows the path from `start` to its end. Refused with the first point that cannot be passed at any speed;
/// else, where a joint would be too fast, with the first such point and the speed that would do.
[[nodiscard]] Result<FollowedPath, Refusal> checkPath(const TimedPath& timed, const arm::JointVector& start);

}  // namespace cobot_command::motion
