// The joints with which a point is reached: closed-form inverse kinematics, with the configuration of the
// point.
#pragma once

#include "points/target.h"

namespace cobot_command::path {

/// At the turns nearest to `start` [rad], where the point leaves them open. Without a configuration in the
/// posture of `start`. Refused as 1026, 1033, 1037, 1044, 1046 or 1047.
[[nodiscard]] Result<arm::JointVector, PathRefusal> jointsOf(const PathPoint& point, int index,
                                                             const Target& target,
                                                             const arm::JointVector& start,
                                                             const PathScene& scene);

}  // namespace cobot_command::path
