#include "kinds/pvt_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "curves/half_turn.h"
#include "paths/input_check.h"
#include "paths/path_trajectory.h"
#include "profiles/cubic.h"
#include "profiles/trapezoid.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

Eigen::Matrix3d crossBy(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

/// The angular velocity, for each unit by which the rotation vector `turn` grows.
Eigen::Matrix3d angularRate(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const Eigen::Matrix3d cross = crossBy(turn);
  const bool small = angle < 1e-4;  // where the closed form loses its digits, its series does
  const double half = std::sin(0.5 * angle) / (0.5 * angle);
  const double first = small ? 0.5 : 0.5 * half * half;
  const double second = small ? 1.0 / 6.0 : (angle - std::sin(angle)) / (angle * angle * angle);
  return Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}

/// Its inverse, for angles up to pi.
Eigen::Matrix3d turnRate(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const Eigen::Matrix3d cross = crossBy(turn);
  const double second =
      angle < 1e-4 ? 1.0 / 12.0 : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
  return Eigen::Matrix3d::Identity() - 0.5 * cross + second * cross * cross;
}

/// Cubics of the position, and of the rotation vector from the orientation of the point before.
class PvtCurve final : public TcpCurve {
 public:
  explicit PvtCurve(const arm::Pose& start) : end_(start) {}

  /// `velocity` in the frame of the curve, as the poses are.
  void append(double duration, const arm::Pose& pose, const PathRate& velocity) {
    const Eigen::Vector3d turn = turnBetween(end_.linear(), pose.linear());
    PathRate from = PathRate::Zero();
    PathRate to;
    PathRate to_slope = velocity;
    from.head<3>() = end_.translation();
    to << pose.translation(), turn;
    to_slope.tail<3>() = turnRate(turn) * velocity.tail<3>();
    segments_.push_back({duration_, Cubic<6>(duration, from, velocity_, to, to_slope), end_.linear()});
    length_ += duration * std::max(velocity_.head<3>().norm(), velocity.head<3>().norm()) +
               (pose.translation() - end_.translation()).norm();
    turn_ += duration * std::max(velocity_.tail<3>().norm(), velocity.tail<3>().norm()) + turn.norm();
    duration_ += duration;
    end_ = pose;
    velocity_ = velocity;
  }

  /// From its end as it is [rad].
  [[nodiscard]] double turnTo(const arm::Pose& pose) const {
    return turnBetween(end_.linear(), pose.linear()).norm();
  }
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] double length() const override { return length_; }
  [[nodiscard]] double turn() const override { return turn_; }
  [[nodiscard]] arm::Pose at(double progress) const override {
    const double time = progress * duration_;
    const Segment& segment = segmentAt(time);
    const PathRate there = segment.cubic.at(time - segment.begin);
    arm::Pose pose = arm::Pose::Identity();
    pose.translation() = there.head<3>();
    pose.linear() = turnedBy(there.tail<3>()) * segment.orientation;
    return pose;
  }
  [[nodiscard]] PathRate rateAt(double progress) const override {
    const double time = progress * duration_;
    const Segment& segment = segmentAt(time);
    PathRate rate = segment.cubic.slopeAt(time - segment.begin);
    rate.tail<3>() = angularRate(segment.cubic.at(time - segment.begin).tail<3>()) * rate.tail<3>();
    return duration_ * rate;
  }
  /// The second derivative of a cubic is linear, so greatest at an end of what is asked for of a segment. The
  /// angular velocity is A(v) v' of the rotation vector v, where A(v) is the mean of the turns R(s v), 0 <= s
  /// <= 1. So |A| <= 1, and as R(s v) turns at most at s |v'|, A changes at most at |v'| / 2: together the
  /// angular velocity changes at most at |v''| + |v'|^2 / 2.
  [[nodiscard]] RateChange rateChange(double from, double to) const override {
    RateChange most;
    const double end = to * duration_;
    for (const Segment* one = &segmentAt(from * duration_); one->begin <= end; ++one) {
      const bool last = one == &segments_.back();
      const double begin = std::max(0.0, from * duration_ - one->begin);
      const double behind = std::max(begin, (last ? end : std::min(end, (one + 1)->begin)) - one->begin);
      const RateChange here = changeWithin(one->cubic, begin, behind);
      most.linear = std::max(most.linear, here.linear);
      most.angular = std::max(most.angular, here.angular);
      if (last) break;
    }
    return {duration_ * duration_ * most.linear, duration_ * duration_ * most.angular};
  }

 private:
  struct Segment {
    double begin;
    Cubic<6> cubic;
    Eigen::Matrix3d orientation;  // at its begin
  };
  [[nodiscard]] static RateChange changeWithin(const Cubic<6>& cubic, double begin, double end) {
    const PathRate first = cubic.curvatureAt(begin);
    const PathRate last = cubic.curvatureAt(end);
    const double turn_change = std::max(first.tail<3>().norm(), last.tail<3>().norm());
    const double middle_speed = cubic.slopeAt(0.5 * (begin + end)).tail<3>().norm();
    const double speed = middle_speed + 0.5 * (end - begin) * turn_change;
    return {std::max(first.head<3>().norm(), last.head<3>().norm()), turn_change + 0.5 * speed * speed};
  }
  [[nodiscard]] const Segment& segmentAt(double time) const {
    const auto behind = std::upper_bound(segments_.begin() + 1, segments_.end(), time,
                                         [](double at, const Segment& one) { return at < one.begin; });
    return *(behind - 1);
  }

  std::vector<Segment> segments_;
  double duration_ = 0.0;
  double length_ = 0.0;
  double turn_ = 0.0;
  arm::Pose end_;
  PathRate velocity_ = PathRate::Zero();
};

Result<TrajectoryPtr, Refusal> planPosePvt(const arm::ArmModel& arm, const arm::JointVector& start,
                                           const std::vector<PvtPosePoint>& points, const Setting& setting) {
  const auto curve = std::make_shared<PvtCurve>(tcpInRobotBase(arm, start, setting));
  for (const PvtPosePoint& point : points) {
    const arm::Pose to = setting.base * point.pose;
    if (auto ambiguous = ambiguousTurn(curve->turnTo(to), to, "PVT", setting)) {
      return refuse(std::move(*ambiguous));
    }
    PathRate velocity;
    velocity << setting.base.linear() * point.velocity.linear, setting.base.linear() * point.velocity.angular;
    curve->append(point.duration / setting.speed_override, to, velocity * setting.speed_override);
  }
  return follow(arm, start,
                {curve, std::make_shared<const Trapezoid>(Trapezoid::steady(curve->duration())), "PVT", {}},
                setting);
}

double speedOf(const arm::JointVector& velocity) {
  return velocity.cwiseAbs().maxCoeff();
}

double speedOf(const TcpVelocity& velocity) {
  return std::max(velocity.linear.norm(), velocity.angular.norm());
}

Refusal refusal(std::string message) {
  Refusal made;
  made.reason = Refusal::Reason::BadParameter;
  made.message = std::move(message);
  return made;
}

}  // namespace

Result<TrajectoryPtr, Refusal> planPvt(const arm::ArmModel& arm, const arm::JointVector& start,
                                       const Pvt& pvt, const Setting& setting) {
  return std::visit(
      [&](const auto& points) -> Result<TrajectoryPtr, Refusal> {
        if (points.empty()) {
          return refuse(refusal("a PVT has no points: give it at least one"));
        }
        if (speedOf(points.back().velocity) > kPvtRest) {
          return refuse(refusal(
              "the last point of a PVT has a velocity, it must be 0 there: end with a point at rest"));
        }
        if constexpr (std::is_same_v<decltype(points), const std::vector<PvtJointPoint>&>) {
          return planJointPvt(arm, start, points, setting);
        } else {
          return planPosePvt(arm, start, points, setting);
        }
      },
      pvt.points);
}

}  // namespace cobot_command::motion
