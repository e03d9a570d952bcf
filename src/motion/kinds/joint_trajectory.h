// All joints on a straight line in joint space, with one progress.
#pragma once

#include <utility>

#include "profiles/profiled.h"

namespace cobot_command::motion {

class JointTrajectory final : public Profiled {
 public:
  JointTrajectory(const arm::JointVector& start, const arm::JointVector& target, ProfilePtr profile)
      : Profiled(start, target, std::move(profile)) {}

 private:
  [[nodiscard]] JointState during(double time) const override {
    const arm::JointVector way = target() - start();
    return {start() + profile().progress(time) * way, profile().rate(time) * way};
  }
  /// The progress only grows, so each joint is between where it is at both ends.
  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    JointRange range = JointRange::of(at(from).position);
    range.include(at(to).position);
    return range;
  }
};

}  // namespace cobot_command::motion
