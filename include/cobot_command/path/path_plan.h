// A path as it is planned wholly: each point with its motion, and where the arm is at every time.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/path/path_point.h"

namespace cobot_command::path {

/// As it counts, in the units of the point.
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
  int goal = 0;   ///< whose point: as the section says
  int index = 0;  ///< in the array of its goal
  PathPoint point;
  Dynamics dynamics;
  double feedrate = 1.0;                          ///< that it was planned with
  arm::Pose moved_frame = arm::Pose::Identity();  ///< in the flange [m]
  motion::Command command;                        ///< in the robot base, at the feedrate
  motion::TrajectoryPtr motion;                   ///< from rest to rest
  Duration start{};                               ///< since the path began
  Duration overlap{};  ///< so long before its end the next one begins; zero: the arm rests on the point

  [[nodiscard]] Duration end() const { return start + motion->duration(); }
  /// It asks for a blend, and rests all the same.
  [[nodiscard]] bool losesBlend() const {
    return is(point.termination_type, Termination::Blend) && overlap == Duration::zero();
  }
};

/// A value: a copy can be tried out and thrown away; its motions are shared.
class PathPlan {
 public:
  struct Place {
    std::size_t point = 0;    ///< the one that moves the arm; while two blend the outgoing one
    double share = 0.0;       ///< of its way, 0..1
    bool blends = false;      ///< with the one behind it
    double next_share = 0.0;  ///< of the way of that one
  };

  explicit PathPlan(const arm::JointVector& start) : start_(start) {}

  [[nodiscard]] const std::vector<PlannedPoint>& points() const { return points_; }
  [[nodiscard]] Duration duration() const {
    return points_.empty() ? Duration::zero() : points_.back().end();
  }
  /// Before the start where it begins, after the duration where it ends; the same time always gives the
  /// bit-identical state.
  [[nodiscard]] motion::JointState at(Duration time) const;
  /// Precondition: there are points.
  [[nodiscard]] Place placeAt(Duration time) const;

  /// Behind the last point, `overlap` before that one's end.
  void append(PlannedPoint point, Duration overlap);
  /// Points `first` to those in front of `behind`, as a path of its own: it begins with the first one, at
  /// time 0, and ends where the last one does.
  [[nodiscard]] PathPlan part(std::size_t first, std::size_t behind) const;

 private:
  [[nodiscard]] arm::JointVector beginOf(std::size_t point) const;
  /// The last that has begun.
  [[nodiscard]] std::size_t begunAt(Duration time) const;

  arm::JointVector start_;
  std::vector<PlannedPoint> points_;
};

}  // namespace cobot_command::path
