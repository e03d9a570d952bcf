// What the trajectories with one profile share: they stand still after the end, and before the start if they
// start from rest.
#pragma once

#include <algorithm>

#include "profiles/trapezoid.h"

#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

class Profiled : public Trajectory {
 public:
  [[nodiscard]] Duration duration() const final { return duration_; }
  [[nodiscard]] Duration rampTime() const final {
    return std::chrono::floor<Duration>(std::chrono::duration<double>(profile_.rampTime()));
  }

  [[nodiscard]] JointState at(Duration time) const final {
    if (time >= duration_) {
      return {end_, arm::JointVector::Zero()};
    }
    if (time > Duration::zero()) {
      return during(std::min(toSeconds(time), profile_.duration()));
    }
    return {start_, profile_.startsAtRest() ? arm::JointVector::Zero() : during(0.0).velocity};
  }

 protected:
  Profiled(const arm::JointVector& start, const arm::JointVector& end, const Trapezoid& profile)
      : start_(start), end_(end), profile_(profile), duration_(fromSeconds(profile.duration())) {}

  [[nodiscard]] const arm::JointVector& start() const { return start_; }
  [[nodiscard]] const arm::JointVector& target() const { return end_; }
  [[nodiscard]] const Trapezoid& profile() const { return profile_; }

 private:
  /// 0 <= time [s] <= duration; 0 only where it does not start from rest.
  [[nodiscard]] virtual JointState during(double time) const = 0;

  arm::JointVector start_;
  arm::JointVector end_;
  Trapezoid profile_;
  Duration duration_;
};

}  // namespace cobot_command::motion
