// From a target to the motion that leads there, with the refusals in the manual's numbers.
#pragma once

#include "points/dynamics.h"
#include "points/target.h"

#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::path {

struct PointMotion {
  motion::Command command;
  motion::TrajectoryPtr motion;
};

/// From `start` [rad], at rest, to rest.
[[nodiscard]] Result<PointMotion, PathRefusal> planPoint(const PathPoint& point, int index,
                                                         const Target& target, const Dynamics& dynamics,
                                                         const arm::JointVector& start,
                                                         const PathScene& scene);

/// A motion that was planned before, from `start`, at the feedrate of the scene.
[[nodiscard]] Result<PointMotion, PathRefusal> planAgain(const PlannedPoint& point,
                                                         const arm::JointVector& start,
                                                         const PathScene& scene);

}  // namespace cobot_command::path
