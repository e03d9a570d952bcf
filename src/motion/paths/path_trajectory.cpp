#include "paths/path_trajectory.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "paths/input_check.h"
#include "paths/path_check.h"
#include "paths/path_postures.h"
#include "paths/path_range.h"
#include "profiles/profiled.h"

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

/// Of a shorter piece no range is looked for [s].
constexpr double kShortestPiece = 1e-6;

class PathTrajectory final : public Profiled {
 public:
  PathTrajectory(const arm::JointVector& start, PathPosturesPtr postures, ProfilePtr profile,
                 FollowedPath followed)
      : Profiled(start, followed.end, std::move(profile)),
        postures_(std::move(postures)),
        followed_(std::move(followed)) {}

  [[nodiscard]] double tcpWay() const override { return postures_->length(); }

 private:
  [[nodiscard]] JointState during(double time) const override {
    const double progress = profile().progress(time);
    const arm::JointVector& near = nearestKept(time);
    const auto joints = postures_->at(progress, near);
    if (!joints) {  // kSingular rules it out; stay finite anyway
      return {near, arm::JointVector::Zero()};
    }
    return {*joints, postures_->velocityAt(progress, profile().rate(time), *joints)};
  }

  [[nodiscard]] Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const override {
    JointRange range = JointRange::of(at(from).position);
    range.include(at(to).position);
    const double end = profile().duration();
    if (const auto stuck = includeAll(std::min(toSeconds(from), end), std::min(toSeconds(to), end), range)) {
      return refuse(unbounded(fromSeconds(stuck->first), fromSeconds(stuck->second),
                              "because the path is too close to a singularity: choose another path, or PTP"));
    }
    return range;
  }

  /// Both halves where the whole is too long [s]; where not even kShortestPiece is short enough, that one.
  [[nodiscard]] std::optional<std::pair<double, double>> includeAll(double from, double to,
                                                                    JointRange& range) const {
    const double middle = 0.5 * (from + to);
    const double progress = profile().progress(middle);
    const PathPiece piece{progress, std::max(0.0, progress - profile().progress(from)),
                          std::max(0.0, profile().progress(to) - progress)};
    const auto joints = postures_->at(progress, nearestKept(middle));
    const auto of_piece = joints ? rangeOnPiece(*postures_, piece, *joints) : std::nullopt;
    if (of_piece) {
      range.include(*of_piece);
      return std::nullopt;
    }
    if (to - from < kShortestPiece) return std::pair(from, to);
    const auto stuck = includeAll(from, middle, range);
    return stuck ? stuck : includeAll(middle, to, range);
  }

  [[nodiscard]] const arm::JointVector& nearestKept(double time) const {
    const auto index = static_cast<std::size_t>(std::lround(time / followed_.period));
    return followed_.postures[std::min(index, followed_.postures.size() - 1)];
  }

  PathPosturesPtr postures_;
  FollowedPath followed_;
};

}  // namespace

Result<TrajectoryPtr, Refusal> follow(const PathPosturesPtr& postures, const arm::JointVector& start,
                                      const ProfilePtr& profile, const TimedWords& words) {
  if (auto too_long = checkDuration(profile->duration())) {
    return refuse(std::move(*too_long));
  }
  if (profile->duration() == 0.0) {
    return TrajectoryPtr(std::make_shared<PathTrajectory>(start, postures, profile,
                                                          FollowedPath{{start}, kSamplePeriod, start}));
  }
  auto followed = checkPath({*postures, *profile, words.name, words.speed, words.base}, start);
  if (!followed) {
    return refuse(std::move(followed.error()));
  }
  return TrajectoryPtr(std::make_shared<PathTrajectory>(start, postures, profile, std::move(*followed)));
}

Result<TrajectoryPtr, Refusal> follow(const arm::ArmModel& arm, const arm::JointVector& start,
                                      const TimedCurve& timed, const Setting& setting) {
  auto postures =
      std::make_shared<const CurvePostures>(arm, timed.curve, setting.tcp, arm::poseBitsOf(arm, start));
  return follow(std::move(postures), start, timed.profile, {timed.name, timed.speed, setting.base});
}

arm::Pose tcpInRobotBase(const arm::ArmModel& arm, const arm::JointVector& joints, const Setting& setting) {
  return arm::forwardKinematics(arm, joints) * setting.tcp;
}

AskedSpeed askedSpeed(const PathSpeed& speed, double length, double time_at_top_speed) {
  if (const auto* ratio = std::get_if<SpeedRatio>(&speed)) {
    return {100.0 * ratio->value, "%", "choose another path, or PTP"};
  }
  const double asked = std::get<TcpSpeed>(speed).metres_per_second;
  return {mToMm(std::min(asked, length / time_at_top_speed)), "mm/s",
          "give it in %, or choose another path, or PTP"};
}

double timeAtTopSpeed(const arm::ArmModel& arm, double length, double turn, const PathSpeed& speed,
                      double speed_override) {
  constexpr double kNoWay = 1e-9;  // [m] and [rad]
  if (length < kNoWay && turn < kNoWay) {
    return 0.0;
  }
  const arm::Ratings& full = arm.ratings();
  const auto* ratio = std::get_if<SpeedRatio>(&speed);
  const double linear =
      ratio ? ratio->value * full.max_tcp_speed : std::get<TcpSpeed>(speed).metres_per_second;
  const double angular = ratio ? ratio->value * full.turn_speed : full.turn_speed;
  return std::max(length / linear, turn / angular) / speed_override;
}

double shareOfFullSpeed(const arm::ArmModel& arm, double length, double turn, const PathSpeed& speed) {
  const double time = timeAtTopSpeed(arm, length, turn, speed, 1.0);
  return time > 0.0 ? timeAtTopSpeed(arm, length, turn, SpeedRatio{1.0}, 1.0) / time : 1.0;
}

}  // namespace cobot_command::motion
