// Where the arm should be on its trajectory, and whether it is on it. How a controller makes a PVT, and how
// late it is, is told nowhere: its way is judged, and its time only by half a second.
#pragma once

#include <memory>
#include <optional>

#include "shared/plan_clock.h"
#include "trajectory/trajectory_plan.h"

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class TrajectoryFollower {
 public:
  /// `rate`: see PlanClock.
  TrajectoryFollower(std::shared_ptr<const TrajectoryPlan> plan, double rate, Instant now);

  /// Until it is let go, time stands still. Where the arm comes to rest, and how it gets up to its speed
  /// again, is not judged.
  void hold(Instant now);
  void letGo(Instant now);

  /// Off the trajectory, by the joint that is so by the most of what is allowed.
  struct Offence {
    int joint = 0;
    double gap = 0;  ///< [rad], from the nearest place
  };
  /// Nothing: the arm, with these joints now, is where it may be; or that is not judged.
  [[nodiscard]] std::optional<Offence> offence(const arm::JointVector& joints, Instant now);

  /// Since it began, by its plan.
  [[nodiscard]] Duration time(Instant now) const;
  [[nodiscard]] Duration remaining(Instant now) const;

 private:
  [[nodiscard]] arm::JointVector gapAt(Duration time, const arm::JointVector& joints) const;
  /// Share of what is allowed; above 1: off.
  [[nodiscard]] double shareAt(Duration time, const arm::JointVector& joints) const;
  [[nodiscard]] Duration nearest(const arm::JointVector& joints, Duration from, Duration until) const;

  std::shared_ptr<const TrajectoryPlan> plan_;
  PlanClock clock_;
  std::optional<Instant> judged_from_;  ///< behind a hold
  Duration seen_{};                     ///< by its plan, where it was last
};

}  // namespace cobot_command::blocks
