// PVT in joint space, in closed form.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kinds/pvt_motion.h"
#include "paths/input_check.h"
#include "profiles/cubic.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/pvt.h"

namespace cobot_command::motion {
namespace {

struct Segment {
  double begin;
  double duration;
  Cubic<6> cubic;
};

/// Where the slope of a joint is none; NaN or infinite where there is no such time.
std::array<double, 2> turningTimes(const Cubic<6>& cubic, Eigen::Index joint) {
  const double a = 3.0 * cubic.cube(joint);
  const double b = cubic.square(joint);  // a t^2 + 2 b t + c is the velocity
  const double c = cubic.slope(joint);
  const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
  return {q / a, c / q};
}

class PvtTrajectory final : public Trajectory {
 public:
  PvtTrajectory(std::vector<Segment> segments, const arm::JointVector& end)
      : segments_(std::move(segments)),
        end_(end),
        duration_(fromSeconds(segments_.back().begin + segments_.back().duration)) {}

  [[nodiscard]] Duration duration() const override { return duration_; }
  [[nodiscard]] Duration timeUp() const override { return Duration::zero(); }
  [[nodiscard]] Duration timeDown() const override { return Duration::zero(); }
  [[nodiscard]] JointState at(Duration time) const override {
    if (time >= duration_) return {end_, arm::JointVector::Zero()};
    const double seconds = std::max(0.0, toSeconds(time));
    const auto behind = std::upper_bound(segments_.begin() + 1, segments_.end(), seconds,
                                         [](double at, const Segment& one) { return at < one.begin; });
    const Segment& segment = *(behind - 1);
    const double within = std::min(seconds - segment.begin, segment.duration);
    return {segment.cubic.at(within), segment.cubic.slopeAt(within)};
  }

 private:
  /// In each segment both ends of what is asked for of it, and where a joint turns round between them.
  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    JointRange range = JointRange::of(at(from).position);
    range.include(at(to).position);
    const double last = toSeconds(to);
    const auto behind = std::upper_bound(segments_.begin() + 1, segments_.end(), toSeconds(from),
                                         [](double at, const Segment& one) { return at < one.begin; });
    for (auto segment = behind - 1; segment != segments_.end() && segment->begin <= last; ++segment) {
      include(*segment, std::clamp(toSeconds(from) - segment->begin, 0.0, segment->duration),
              std::min(last - segment->begin, segment->duration), range);
    }
    return range;
  }
  static void include(const Segment& segment, double from, double to, JointRange& range) {
    range.include(segment.cubic.at(from));
    range.include(segment.cubic.at(to));
    for (Eigen::Index i = 0; i < range.lower.size(); ++i) {
      for (const double time : turningTimes(segment.cubic, i)) {
        if (!(time > from && time < to)) continue;  // NaN, too, is outside
        const double there = segment.cubic.at(time)[i];
        range.lower[i] = std::min(range.lower[i], there);
        range.upper[i] = std::max(range.upper[i], there);
      }
    }
  }

  std::vector<Segment> segments_;
  arm::JointVector end_;
  Duration duration_;
};

/// Where a joint turns round within a segment, and where it is fastest; and the end of the segment.
struct Extremes {
  std::array<double, 3> of_position;
  std::array<double, 2> of_velocity;
};

Extremes extremes(const Segment& segment, Eigen::Index joint) {
  const auto within = [&](double time) {  // NaN, too, is outside
    return time > 0.0 && time < segment.duration ? time : segment.duration;
  };
  const auto [one, other] = turningTimes(segment.cubic, joint);
  const double fastest = -segment.cubic.square(joint) / (3.0 * segment.cubic.cube(joint));
  return {{within(one), within(other), segment.duration}, {within(fastest), segment.duration}};
}

/// Of one segment.
std::optional<PvtOffence> offenceIn(const arm::ArmModel& arm, const Segment& segment, const PvtRoom& room) {
  const arm::JointVector from = segment.cubic.at(0.0);
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    const arm::JointLimit& limit = arm.limits()[i];
    const double lower = std::min(limit.lower, from[joint]) - room.position;
    const double upper = std::max(limit.upper, from[joint]) + room.position;
    const Extremes at = extremes(segment, joint);
    const auto offence = [&](Refusal::Reason reason, double time, double found) {
      return PvtOffence{reason, static_cast<int>(i), time, found, segment.cubic.at(time)};
    };
    for (const double time : at.of_position) {
      const double found = segment.cubic.at(time)[joint];
      if (found < lower || found > upper) return offence(Refusal::Reason::JointLimit, time, found);
    }
    for (const double time : at.of_velocity) {
      const double needed = std::abs(segment.cubic.slopeAt(time)[joint]);
      if (needed > limit.max_velocity * (1.0 + room.speed)) {
        return offence(Refusal::Reason::JointSpeed, time, needed);
      }
    }
  }
  return std::nullopt;
}

std::string textOf(const PvtOffence& offence, const arm::JointLimit& limit) {
  if (offence.reason == Refusal::Reason::JointLimit) {
    return fmt::format("would reach {:.2f} deg, allowed {:.1f}..{:.1f} deg", radToDeg(offence.found),
                       radToDeg(limit.lower), radToDeg(limit.upper));
  }
  return fmt::format(
      "would need {:.1f} deg/s, rated {:.1f} deg/s: give the point more time or another velocity",
      radToDeg(offence.found), radToDeg(limit.max_velocity));
}

Refusal toRefusal(const arm::ArmModel& arm, const PvtOffence& offence, double begin, double duration,
                  const Setting& setting) {
  const arm::JointLimit& limit = arm.limits()[static_cast<std::size_t>(offence.joint)];
  return {offence.reason, (begin + offence.time) / duration, offence.joint,
          setting.base.inverse() * arm::forwardKinematics(arm, offence.joints) * setting.tcp,
          fmt::format("{:.3f} s after the start of the PVT J{} {}", begin + offence.time, offence.joint + 1,
                      textOf(offence, limit))};
}

}  // namespace

std::optional<PvtOffence> checkPvtSegment(const arm::ArmModel& arm, const JointState& from,
                                          const PvtJointPoint& to, const PvtRoom& room) {
  return offenceIn(
      arm, {0.0, to.duration, {to.duration, from.position, from.velocity, to.position, to.velocity}}, room);
}

Result<TrajectoryPtr, Refusal> planJointPvt(const arm::ArmModel& arm, const arm::JointVector& start,
                                            const std::vector<PvtJointPoint>& points,
                                            const Setting& setting) {
  std::vector<Segment> segments;
  double end = 0.0;
  arm::JointVector position = start;
  arm::JointVector velocity = arm::JointVector::Zero();
  for (const PvtJointPoint& point : points) {
    const double duration = point.duration / setting.speed_override;
    const arm::JointVector next = point.velocity * setting.speed_override;
    segments.push_back({end, duration, Cubic<6>(duration, position, velocity, point.position, next)});
    position = point.position;
    velocity = next;
    end += duration;
  }
  if (auto too_long = checkDuration(end)) return refuse(std::move(*too_long));
  for (const Segment& segment : segments) {
    if (const auto found = offenceIn(arm, segment, PvtRoom())) {
      return refuse(toRefusal(arm, *found, segment.begin, end, setting));
    }
  }
  return TrajectoryPtr(std::make_shared<PvtTrajectory>(std::move(segments), position));
}

}  // namespace cobot_command::motion
