#include "cobot_command/motion/blend.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "kinds/pline_motion.h"
#include "paths/path_check.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::motion {
namespace {

/// Room for rounding where the TCP is compared to the radius [m].
constexpr double kRadiusTolerance = 1e-9;
/// So far a joint may go between two samples of a corner [rad].
constexpr double kCornerWay = 5e-3;
/// A shorter overlap is not worth looking for.
constexpr Duration kShortest = std::chrono::milliseconds(1);

/// Of what is seen of an overlap, how wide a range of a part of it is at most; or kFine [rad].
constexpr double kClose = 0.5;
constexpr double kFine = 1e-6;

class BlendedTrajectory final : public Trajectory {
 public:
  BlendedTrajectory(TrajectoryPtr before, TrajectoryPtr next, Duration overlap)
      : before_(std::move(before)), next_(std::move(next)), overlap_(overlap) {}

  [[nodiscard]] Duration duration() const override { return next_->duration(); }
  [[nodiscard]] Duration timeUp() const override { return next_->timeUp(); }
  [[nodiscard]] Duration timeDown() const override { return next_->timeDown(); }
  [[nodiscard]] double progress(Duration time) const override { return next_->progress(time); }
  [[nodiscard]] double tcpWay() const override { return next_->tcpWay(); }
  [[nodiscard]] JointState at(Duration time) const override {
    return stateIn(*before_, *next_, overlap_, time);
  }

 private:
  /// The sum of both while they overlap, and `next` alone behind that.
  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    if (from >= overlap_) return next_->jointRange(from, to);
    const Duration last = std::min(to, overlap_);
    JointRange seen = JointRange::of(at(from).position);
    seen.include(at(from + (last - from) / 2).position);
    seen.include(at(last).position);
    auto range = sumWithin(from, last, std::max(kClose * seen.widths().maxCoeff(), kFine));
    if (!range || to <= overlap_) return range;
    return united(*range, next_->jointRange(overlap_, to));
  }
  /// Where the one undoes what the other does, the sum of their ranges is far wider than that of their sum.
  /// In parts no wider than `widest` it is wider than that by one of them on either side.
  [[nodiscard]] Result<JointRange, Unbounded> sumWithin(Duration from, Duration to, double widest) const {
    const Duration begin = before_->duration() - overlap_;
    auto range = cornerRange(*before_, {begin + from, begin + to}, *next_, {from, to});
    const Duration middle = from + (to - from) / 2;
    if (!range || middle == from || range->widths().maxCoeff() <= widest) return range;
    const auto half = sumWithin(from, middle, widest);
    return half ? united(*half, sumWithin(middle, to, widest)) : half;
  }
  [[nodiscard]] static Result<JointRange, Unbounded> united(JointRange range,
                                                            const Result<JointRange, Unbounded>& other) {
    if (!other) return other;
    range.include(*other);
    return range;
  }

  TrajectoryPtr before_;
  TrajectoryPtr next_;
  Duration overlap_;
};

Duration partOf(Duration most, const BlendShare& share) {
  const double part = std::clamp(share.value, 0.0, 1.0) * static_cast<double>(most.count());
  return Duration(static_cast<Duration::rep>(part));
}

double radiusOf(const Blend& blend) {
  if (const auto* radius = std::get_if<BlendRadius>(&blend)) return radius->metres;
  const auto* way = std::get_if<BlendWay>(&blend);
  return way ? way->radius : std::numeric_limits<double>::infinity();
}

/// The longest time up to `most` that is `good`, where all shorter ones are, too.
template <class Good>
Duration longest(Duration most, const Good& good) {
  Duration within{};
  Duration beyond = most + Duration(1);
  while (beyond - within > Duration(1)) {
    const Duration middle = within + (beyond - within) / 2;
    (good(middle) ? within : beyond) = middle;
  }
  return within;
}

Duration longestWithin(const Corner& corner, const BlendWay& way, Duration most) {
  constexpr double kRounding = 1e-12;
  return longest(most, [&](Duration overlap) {
    return corner.before.progress(corner.before.duration() - overlap) >= 1.0 - way.before - kRounding &&
           corner.next.progress(overlap) <= way.next + kRounding;
  });
}

class CornerCheck {
 public:
  CornerCheck(const arm::ArmModel& arm, const Corner& corner, double radius)
      : arm_(arm), corner_(corner), point_(tcpAt(corner.before.end().position)), radius_(radius) {}

  /// The longest overlap up to `most` over which both motions are within the radius.
  [[nodiscard]] Duration longestWithinRadius(Duration most) const {
    return longest(most, [&](Duration overlap) { return areWithinRadius(overlap); });
  }

  /// The same of the end of the one alone, and of the beginning of the other.
  [[nodiscard]] Duration longestOfBefore(Duration most) const {
    return longest(most, [&](Duration overlap) { return isBeforeWithinRadius(overlap); });
  }
  [[nodiscard]] Duration longestOfNext(Duration most) const {
    return longest(most, [&](Duration overlap) { return isNextWithinRadius(overlap); });
  }

  /// Whether the arm can follow the sum.
  [[nodiscard]] bool canBeMade(Duration overlap) const {
    const auto steps = static_cast<Duration::rep>(std::ceil(toSeconds(overlap) / samplePeriod(overlap)));
    for (Duration::rep i = 0; i <= steps; ++i) {
      const JointState state = stateIn(corner_.before, corner_.next, overlap, overlap * i / steps);
      if (arm_.firstJointOutsideLimits(state.position) >= 0 || isTooFast(state.velocity) ||
          !isWithinRadius(state.position)) {
        return false;
      }
    }
    return true;
  }

 private:
  /// Short enough that no joint goes further than kCornerWay meanwhile [s]; both motions are fastest at the
  /// ends.
  [[nodiscard]] double samplePeriod(Duration overlap) const {
    const Trajectory& before = corner_.before;
    const double fastest = before.at(before.duration() - overlap).velocity.cwiseAbs().maxCoeff() +
                           corner_.next.at(overlap).velocity.cwiseAbs().maxCoeff();
    return std::clamp(kCornerWay / fastest, kSamplePeriod, kLongestSamplePeriod);
  }
  [[nodiscard]] Eigen::Vector3d tcpAt(const arm::JointVector& joints) const {
    return (arm::forwardKinematics(arm_, joints) * corner_.tcp).translation();
  }
  [[nodiscard]] double fromPoint(const arm::JointVector& joints) const {
    return (tcpAt(joints) - point_).norm();
  }
  [[nodiscard]] bool isWithinRadius(const arm::JointVector& joints) const {
    return std::isinf(radius_) || fromPoint(joints) <= radius_ + kRadiusTolerance;
  }
  [[nodiscard]] bool isBeforeWithinRadius(Duration overlap) const {
    const Trajectory& before = corner_.before;
    return fromPoint(before.at(before.duration() - overlap).position) <= radius_;
  }
  [[nodiscard]] bool isNextWithinRadius(Duration overlap) const {
    return fromPoint(corner_.next.at(overlap).position) <= radius_;
  }
  [[nodiscard]] bool areWithinRadius(Duration overlap) const {
    return isBeforeWithinRadius(overlap) && isNextWithinRadius(overlap);
  }
  [[nodiscard]] bool isTooFast(const arm::JointVector& velocity) const {
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      const double rated = arm_.limits()[i].max_velocity;
      if (std::abs(velocity[static_cast<Eigen::Index>(i)]) > rated * (1.0 + kSpeedTolerance)) {
        return true;
      }
    }
    return false;
  }

  const arm::ArmModel& arm_;
  const Corner& corner_;
  Eigen::Vector3d point_;
  double radius_;
};

}  // namespace

JointState stateIn(const Trajectory& before, const Trajectory& next, Duration overlap, Duration time) {
  const Duration clamped = std::max(time, Duration::zero());
  JointState state = next.at(clamped);
  if (clamped < overlap) {
    const JointState fading = before.at(before.duration() - overlap + clamped);
    state.position += fading.position - before.end().position;
    state.velocity += fading.velocity;
  }
  return state;
}

Result<JointRange, Unbounded> cornerRange(const Trajectory& before, const Interval& of_before,
                                          const Trajectory& next, const Interval& of_next) {
  auto range = before.jointRange(of_before.from, of_before.to);
  if (!range) return range;
  auto of_other = next.jointRange(of_next.from, of_next.to);
  if (!of_other) return of_other;
  const arm::JointVector corner = before.end().position;
  range->lower += of_other->lower - corner;
  range->upper += of_other->upper - corner;
  return range;
}

Duration longestOverlap(const arm::ArmModel& arm, const Corner& corner, const Blend& blend) {
  const Duration most = std::min({corner.before.timeDown(), corner.next.timeUp(),
                                  corner.before.duration() / 2, corner.next.duration() / 2});
  if (const auto* share = std::get_if<BlendShare>(&blend)) return partOf(most, *share);
  if (const auto* way = std::get_if<BlendWay>(&blend)) return longestWithin(corner, *way, most);
  const double radius = std::get<BlendRadius>(blend).metres;
  return radius > 0.0 ? CornerCheck(arm, corner, radius).longestWithinRadius(most) : Duration{};
}

// A ramp of the time T to the speed V has V t^2 / 2 T of way in the time t. At the share s of the project
// speed V is s V, and a motion too short for it has ramps of the time that grows as 1 / sqrt(s), up to T. So
// s T^2, and with it the way on any share of a ramp, is largest at full speed: what a motion makes in an
// overlap at s it makes at full speed in sqrt(s) of the time, which is within its own ramp there. A radius is
// reached at full speed in sqrt(s) of the time, too.
CornerReach cornerReach(const arm::ArmModel& arm, const Corner& corner, const Blend& blend) {
  const CornerReach most{std::min(corner.before.timeDown(), corner.before.duration() / 2),
                         std::min(corner.next.timeUp(), corner.next.duration() / 2)};
  if (most.before <= Duration::zero() || most.next <= Duration::zero()) return {};
  if (const auto* share = std::get_if<BlendShare>(&blend)) {
    return {partOf(most.before, *share), partOf(most.next, *share)};
  }
  if (const auto* way = std::get_if<BlendWay>(&blend)) {
    return {longestWithin(corner, {way->before, 1.0}, most.before),
            longestWithin(corner, {1.0, way->next}, most.next)};
  }
  const double radius = std::get<BlendRadius>(blend).metres;
  if (radius <= 0.0) return {};
  const CornerCheck check(arm, corner, radius);
  return {check.longestOfBefore(most.before), check.longestOfNext(most.next)};
}

Duration overlapAt(const arm::ArmModel& arm, const Corner& corner, const Blend& blend,
                   const OverlapLimits& limits) {
  const CornerCheck check(arm, corner, radiusOf(blend));
  const auto on_grid = [&](Duration time) { return time - time % limits.step; };
  const Duration shortest = std::max(kShortest, limits.least);

  const Duration asked = longestOverlap(arm, corner, blend);
  Duration overlap = on_grid(std::max(std::min(asked, limits.most), Duration::zero()));
  if (overlap < limits.least) return Duration::zero();
  while (overlap > Duration::zero() && !check.canBeMade(overlap)) {
    overlap = overlap / 2 < shortest ? Duration::zero() : on_grid(overlap / 2);
  }
  return overlap;
}

TrajectoryPtr blended(const TrajectoryPtr& before, const TrajectoryPtr& next, Duration overlap) {
  if (overlap <= Duration::zero()) {
    return next;
  }
  return std::make_shared<BlendedTrajectory>(before, next, overlap);
}

Passage passInto(const arm::ArmModel& arm, const TrajectoryPtr& before, const TrajectoryPtr& next,
                 const arm::Pose& tcp, const Blend& blend, Duration left) {
  if (const auto* share = std::get_if<BlendShare>(&blend)) {
    if (auto passage = passOn(arm, *before, *next, *share, left)) return std::move(*passage);
  }
  const Duration overlap = overlapAt(arm, {*before, *next, tcp}, blend, {left});
  return {overlap, blended(before, next, overlap), next};
}

}  // namespace cobot_command::motion
