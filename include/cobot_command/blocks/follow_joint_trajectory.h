// A timed trajectory of all joints, as in control_msgs/FollowJointTrajectory, the interface of MoveIt and
// others. It is sent to the robot as one PVT, and its tolerances are monitored.
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

/// Vectors of any size may arrive; valid ones hold J1..J6.
struct TrajectoryPoint {
  double time = 0;                 ///< since the start of the trajectory [s]
  std::vector<double> positions;   ///< [rad]
  std::vector<double> velocities;  ///< [rad/s]; given for all points or for none: then they are derived
};

struct FollowJointTrajectoryGoal {
  static constexpr const char* kName = "follow_joint_trajectory";
  [[nodiscard]] static ErrorTable errors();

  std::vector<TrajectoryPoint> points;  ///< empty: only stops the running command
  std::string names_fault;  ///< why the names are not those of the robot's joints; empty: they match
  // Per joint [rad]; 0: default of this layer, negative: no limit.
  SixValues path_tolerance{};
  SixValues goal_tolerance{};
  /// Time after the end of the trajectory to reach the goal tolerance [s]; 0: as for other motions.
  double goal_time_tolerance = 0;
  double starts_in = 0;  ///< time from its turn to its start [s]; negative: the start is already past
  /// A client that sends a new trajectory wants to replace the old one; the action has no field for this.
  int buffer_mode = static_cast<int>(BufferMode::Aborting);
};

struct TrajectoryPlan;

/// Detail of the outcome, also if the goal was refused.
struct TrajectoryReport {
  int error_index = -1;  ///< index of the point that caused the error; -1: none
  int error_joint = -1;  ///< 0..5: joint that caused the error; -1: none
  std::shared_ptr<const TrajectoryPlan> plan = nullptr;  ///< set by plan(), for the run
};

/// Detail of the progress: desired and actual joints at this time [rad, rad/s].
struct TrajectoryPlace {
  Duration time{};  ///< planned time since the start
  SixValues desired{};
  SixValues desired_velocities{};
  std::optional<SixValues> actual;  ///< nullopt: unknown
};

[[nodiscard]] GoalTraits traitsOf(const FollowJointTrajectoryGoal& goal);
[[nodiscard]] std::vector<Failure> check(const FollowJointTrajectoryGoal& goal);
/// Plans the trajectory from the present position of the robot.
[[nodiscard]] Outcome plan(const FollowJointTrajectoryGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const FollowJointTrajectoryGoal& goal, GoalId id,
                                         const Outcome& planned, Instant now);

}  // namespace cobot_command::blocks
