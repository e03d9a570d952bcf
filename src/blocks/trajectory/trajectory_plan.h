// The points of a trajectory as one PVT, planned from where the robot stands.
#pragma once

#include <memory>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/follow_joint_trajectory.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/blocks/shared/planning_scene.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::blocks {

/// Between points that go to the controller, and from the start to the first one [s].
inline constexpr double kLeastTime = toSeconds(motion::kLeastSegment);

struct TrajectoryPlan {
  motion::TrajectoryPtr motion;  ///< nullptr: there is nothing to move
  Order order;                   ///< of the same
  // Of each joint [rad]; infinite: any.
  arm::JointVector path_tolerance = arm::JointVector::Zero();
  arm::JointVector goal_tolerance = arm::JointVector::Zero();
};

/// Fewer apart than a PVT can have segments are left out, where that changes no more than the path tolerance
/// allows. Precondition: the goal was checked, arm and start of the scene are known.
[[nodiscard]] Result<std::shared_ptr<const TrajectoryPlan>, Failure> planTrajectory(
    const FollowJointTrajectoryGoal& goal, const PlanningScene& scene);

/// Velocities at which the points are passed that have none: of the parabola through each point and those
/// beside it, but never so that a joint would go beyond a point; at rest at the start and at the last one.
/// `start`: where the first segment begins.
void deriveVelocities(const arm::JointVector& start, std::vector<motion::PvtJointPoint>& points);

}  // namespace cobot_command::blocks
