// A completely planned path: each point with its motion, and the position of the arm at every time.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/path/path_point.h"

namespace cobot_command::path {

/// The effective dynamics, in the units of the point.
struct Dynamics {
  double speed = 0;
  double acceleration = 0;
  double deceleration = 0;
  double acceleration_jerk = 0;  ///< [%]
  double deceleration_jerk = 0;
  double orientation_speed = 0;  ///< Cartesian paths only
  double orientation_acceleration = 0;
  double orientation_deceleration = 0;
};

struct PlannedPoint {
  int goal = 0;   ///< the goal of the point, from its section
  int index = 0;  ///< in the array of its goal
  PathPoint point;
  Dynamics dynamics;
  double feedrate = 1.0;                          ///< that it was planned with
  arm::Pose moved_frame = arm::Pose::Identity();  ///< in the flange [m]
  motion::Command command;                        ///< in the robot base, at the feedrate
  motion::TrajectoryPtr motion;                   ///< from rest to rest
  Duration start{};                               ///< since the path began
  Duration overlap{};  ///< time before its end at which the next one starts; zero: a stop on the point

  [[nodiscard]] Duration end() const { return start + motion->duration(); }
  /// True if the point requests a blend, but the arm stops on it.
  [[nodiscard]] bool losesBlend() const {
    return is(point.termination_type, Termination::Blend) && overlap == Duration::zero();
  }
};

/// A value: a copy can be changed and discarded; copies share the motions.
class PathPlan {
 public:
  struct Place {
    std::size_t point = 0;    ///< the point that moves the arm; during a blend the outgoing point
    double share = 0.0;       ///< completed share of its path, 0..1
    bool blends = false;      ///< with the next point
    double next_share = 0.0;  ///< completed share of the path of the next point
  };

  explicit PathPlan(const arm::JointVector& start) : start_(start) {}

  [[nodiscard]] const std::vector<PlannedPoint>& points() const { return points_; }
  [[nodiscard]] Duration duration() const {
    return points_.empty() ? Duration::zero() : points_.back().end();
  }
  /// Before the start the start, after the duration the end. The same time always gives the bit-identical
  /// state.
  [[nodiscard]] motion::JointState at(Duration time) const;
  /// Precondition: the plan has points.
  [[nodiscard]] Place placeAt(Duration time) const;

  /// Appends the point; its motion starts `overlap` before the end of the last point.
  void append(PlannedPoint point, Duration overlap);
  /// Points `first` up to, not including, `behind`, as a separate path: it starts with `first` at time 0 and
  /// ends at the end of the last point.
  [[nodiscard]] PathPlan part(std::size_t first, std::size_t behind) const;

 private:
  [[nodiscard]] arm::JointVector beginOf(std::size_t point) const;
  /// The last point that has started.
  [[nodiscard]] std::size_t begunAt(Duration time) const;

  arm::JointVector start_;
  std::vector<PlannedPoint> points_;
};

}  // namespace cobot_command::path
