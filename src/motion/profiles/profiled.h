// What the trajectories with one profile share: they stand still after the end, and before the start if they
// start from rest.
#pragma once

#include <algorithm>
#include <utility>

#include "profiles/profile.h"

#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

class Profiled : public Trajectory {
 public:
  [[nodiscard]] Duration duration() const final { return duration_; }
  [[nodiscard]] Duration timeUp() const final { return floorOf(profile_->timeUp()); }
  [[nodiscard]] Duration timeDown() const final { return floorOf(profile_->timeDown()); }
  [[nodiscard]] double progress(Duration time) const final {
    if (time >= duration_) return 1.0;
    return time <= Duration::zero() ? 0.0
                                    : profile_->progress(std::min(toSeconds(time), profile_->duration()));
  }

  [[nodiscard]] JointState at(Duration time) const final {
    if (time >= duration_) {
      return {end_, arm::JointVector::Zero()};
    }
    if (time > Duration::zero()) {
      return during(std::min(toSeconds(time), profile_->duration()));
    }
    return {start_, profile_->startsAtRest() ? arm::JointVector::Zero() : during(0.0).velocity};
  }

 protected:
  Profiled(const arm::JointVector& start, const arm::JointVector& end, ProfilePtr profile)
      : start_(start), end_(end), profile_(std::move(profile)), duration_(profile_->time()) {}

  [[nodiscard]] const arm::JointVector& start() const { return start_; }
  [[nodiscard]] const arm::JointVector& target() const { return end_; }
  [[nodiscard]] const Profile& profile() const { return *profile_; }

 private:
  [[nodiscard]] static Duration floorOf(double seconds) {
    constexpr double kRounding = 1e-12;  // [s]; the nanosecond below is not meant
    return std::chrono::floor<Duration>(std::chrono::duration<double>(seconds + kRounding));
  }
  /// 0 <= time [s] <= duration; 0 only where it does not start from rest.
  [[nodiscard]] virtual JointState during(double time) const = 0;

  arm::JointVector start_;
  arm::JointVector end_;
  ProfilePtr profile_;
  Duration duration_;
};

}  // namespace cobot_command::motion
