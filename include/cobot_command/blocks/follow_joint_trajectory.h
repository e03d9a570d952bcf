// A trajectory of all joints with its times, as control_msgs/FollowJointTrajectory: what MoveIt and others
// speak. It goes to the robot as one PVT, and its tolerances are watched.
// doc/actions/follow_joint_trajectory.md.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

/// Any sizes may come; J1..J6 otherwise.
struct TrajectoryPoint {
  double time = 0;                 ///< since the trajectory began [s]
  std::vector<double> positions;   ///< [rad]
  std::vector<double> velocities;  ///< [rad/s]; those of all points, or of none: then they are derived
};

struct FollowJointTrajectoryGoal {
  static constexpr const char* kName = "follow_joint_trajectory";
  [[nodiscard]] static ErrorTable errors();

  std::vector<TrajectoryPoint> points;  ///< none: what is under way is stopped, and that is all
  std::string names_fault;  ///< why the names are not those of the robot's joints; empty: they are
  // Of each joint [rad]; 0: as this layer sees fit, negative: any.
  SixValues path_tolerance{};
  SixValues goal_tolerance{};
  double goal_time_tolerance = 0;  ///< for the goal tolerance, behind its end [s]; 0: as for other motions
  double starts_in = 0;            ///< from its turn on [s]; negative: it should have begun so long ago
  /// Who sends a new trajectory means that in place of the old one; the action has no field for it.
  int buffer_mode = static_cast<int>(BufferMode::Aborting);
};

struct TrajectoryPlan;

/// Detail of its end; also where it was refused.
struct TrajectoryReport {
  int error_index = -1;                                  ///< of the point to blame; -1: none
  int error_joint = -1;                                  ///< 0..5; -1: none
  std::shared_ptr<const TrajectoryPlan> plan = nullptr;  ///< of a plan, for the run that it becomes
};

/// Detail of its progress: where the joints should be by now [rad, rad/s], and are.
struct TrajectoryPlace {
  Duration time{};  ///< since it began, by its plan
  SixValues desired{};
  SixValues desired_velocities{};
  std::optional<SixValues> actual;  ///< nothing: nobody knows
};

[[nodiscard]] GoalTraits traitsOf(const FollowJointTrajectoryGoal& goal);
[[nodiscard]] std::vector<Failure> check(const FollowJointTrajectoryGoal& goal);
/// From where the robot stands.
[[nodiscard]] Outcome plan(const FollowJointTrajectoryGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const FollowJointTrajectoryGoal& goal, GoalId id,
                                         const Outcome& planned, Instant now);

}  // namespace cobot_command::blocks
