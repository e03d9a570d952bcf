#include "kinds/joint_velocity.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "paths/path_check.h"
#include "paths/path_trajectory.h"
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

/// Evenly from one velocity to another, that for a while, and evenly to rest.
class JointVelocityTrajectory final : public Trajectory {
 public:
  JointVelocityTrajectory(const JointState& from, const arm::JointVector& velocity,
                          const VelocityTimes& times)
      : from_(from),
        velocity_(velocity),
        ramp_(times.ramp),
        steady_(times.steady),
        duration_(fromSeconds(times.ramp + times.steady + times.ramp)) {}

  [[nodiscard]] Duration duration() const override { return duration_; }
  [[nodiscard]] Duration timeUp() const override { return Duration::zero(); }
  [[nodiscard]] Duration timeDown() const override { return Duration::zero(); }
  [[nodiscard]] JointState at(Duration time) const override {
    const double t = std::clamp(toSeconds(time), 0.0, ramp_ + steady_ + ramp_);
    const double speeding = std::min(t, ramp_);
    const double behind = t - speeding;
    const double slowing = std::max(0.0, behind - steady_);
    const arm::JointVector gain = (velocity_ - from_.velocity) / ramp_;
    JointState state;
    state.position = from_.position + speeding * (from_.velocity + 0.5 * speeding * gain) +
                     (behind - 0.5 * slowing * (slowing / ramp_)) * velocity_;
    if (time >= duration_) {
      state.velocity.setZero();
    } else if (t < ramp_) {
      state.velocity = from_.velocity + t * gain;
    } else {
      state.velocity = (1.0 - slowing / ramp_) * velocity_;
    }
    return state;
  }

 private:
  /// A joint turns round in the first ramp or nowhere: behind it, its speed only falls.
  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    JointRange range = JointRange::of(at(from).position);
    range.include(at(to).position);
    for (Eigen::Index i = 0; i < velocity_.size(); ++i) {
      const double begin = from_.velocity[i];
      if (begin * velocity_[i] >= 0.0) continue;
      const double turn = ramp_ * (begin / (begin - velocity_[i]));
      if (turn <= toSeconds(from) || turn >= toSeconds(to)) continue;
      const double there = from_.position[i] + 0.5 * turn * begin;
      range.lower[i] = std::min(range.lower[i], there);
      range.upper[i] = std::max(range.upper[i], there);
    }
    return range;
  }

  JointState from_;
  arm::JointVector velocity_;
  double ramp_;
  double steady_;
  Duration duration_;
};

/// One joint on its way to `to` [rad/s] and back to rest.
struct JointWay {
  double position;
  double from;
  double to;
  double ramp;

  /// At rest without any steady time: the mean speed of each ramp is half of the sum of those at its ends.
  [[nodiscard]] double rest() const { return position + 0.5 * ramp * (from + to) + 0.5 * ramp * to; }
  /// Where it turns round within the first ramp; else where it is.
  [[nodiscard]] double turned() const {
    return from * to < 0.0 ? position + 0.5 * from * ramp * (from / (from - to)) : position;
  }
  [[nodiscard]] bool isInside(const arm::JointLimit& limit) const {
    return std::min(rest(), turned()) >= limit.lower && std::max(rest(), turned()) <= limit.upper;
  }
  /// The steady time at whose end it can come to rest at its limit.
  [[nodiscard]] double room(const arm::JointLimit& limit) const {
    return ((to > 0.0 ? limit.upper : limit.lower) - rest()) / to;
  }
};

class Planner {
 public:
  Planner(const arm::ArmModel& arm, const Setting& setting) : arm_(arm), setting_(setting) {}

  [[nodiscard]] Refusal tooFast(std::size_t joint, double asked, const arm::JointVector& there) const {
    return refusal(
        Refusal::Reason::JointSpeed, joint, there,
        fmt::format("the requested speed of J{} is {:.1f} deg/s, rated {:.1f} deg/s: choose a lower speed",
                    joint + 1, radToDeg(asked), radToDeg(limit(joint).max_velocity)));
  }
  [[nodiscard]] Refusal tooClose(std::size_t joint, double asked, const arm::JointVector& there) const {
    return refusal(Refusal::Reason::JointLimit, joint, there,
                   fmt::format("J{} at {:.2f} deg is too close to its limits, {}, for {:.1f} deg/s: choose a "
                               "lower speed or the other direction",
                               joint + 1, radToDeg(there[static_cast<Eigen::Index>(joint)]), range(joint),
                               radToDeg(asked)));
  }
  [[nodiscard]] Refusal atLimit(std::size_t joint, const arm::JointVector& there) const {
    return refusal(
        Refusal::Reason::JointLimit, joint, there,
        fmt::format("J{} reaches its limit, {}: choose another direction", joint + 1, range(joint)));
  }
  [[nodiscard]] const arm::JointLimit& limit(std::size_t joint) const { return arm_.limits()[joint]; }

 private:
  [[nodiscard]] Refusal refusal(Refusal::Reason reason, std::size_t joint, const arm::JointVector& there,
                                std::string message) const {
    return {reason, 1.0, static_cast<int>(joint),
            setting_.base.inverse() * tcpInRobotBase(arm_, there, setting_), std::move(message)};
  }
  [[nodiscard]] std::string range(std::size_t joint) const {
    return fmt::format("{:.1f}..{:.1f} deg", radToDeg(limit(joint).lower), radToDeg(limit(joint).upper));
  }

  const arm::ArmModel& arm_;
  const Setting& setting_;
};

}  // namespace

Result<VelocityMotion, Refusal> planJointVelocity(const arm::ArmModel& arm, const JointState& now,
                                                  const arm::JointVector& velocity,
                                                  const VelocityTimes& times, const Setting& setting) {
  const Planner planner(arm, setting);
  VelocityTimes possible = times;
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    const double asked = velocity[joint];
    if (std::abs(asked) > planner.limit(i).max_velocity * (1.0 + kSpeedTolerance)) {
      return refuse(planner.tooFast(i, asked, now.position));
    }
    const JointWay way{now.position[joint], now.velocity[joint], asked, times.ramp};
    if (!way.isInside(planner.limit(i))) return refuse(planner.tooClose(i, asked, now.position));
    if (asked == 0.0 || way.room(planner.limit(i)) >= possible.steady) continue;
    possible.steady = way.room(planner.limit(i));
    first = i;
  }
  VelocityMotion made{std::make_shared<JointVelocityTrajectory>(now, velocity, possible), {}};
  if (first) made.ends_at = planner.atLimit(*first, made.trajectory->end().position);
  return made;
}

}  // namespace cobot_command::motion
