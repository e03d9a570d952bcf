#include "paths/path_trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "paths/input_check.h"
#include "paths/path_check.h"
#include "paths/path_postures.h"
#include "profiles/profiled.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::motion {
namespace {

class PathTrajectory final : public Profiled {
 public:
  PathTrajectory(const arm::JointVector& start, PathPostures postures, const Trapezoid& profile,
                 FollowedPath followed)
      : Profiled(start, followed.end, profile),
        postures_(std::move(postures)),
        followed_(std::move(followed)) {}

 private:
  [[nodiscard]] JointState during(double time) const override {
    const double progress = profile().progress(time);
    const arm::JointVector& near = nearestKept(time);
    const auto joints = postures_.at(progress, near);
    if (!joints) {  // kSingular rules it out; stay finite anyway
      return {near, arm::JointVector::Zero()};
    }
    return {*joints, postures_.velocityAt(progress, profile().rate(time), *joints)};
  }

  [[nodiscard]] const arm::JointVector& nearestKept(double time) const {
    const auto index = static_cast<std::size_t>(std::lround(time / followed_.period));
    return followed_.postures[std::min(index, followed_.postures.size() - 1)];
  }

  PathPostures postures_;
  FollowedPath followed_;
};

}  // namespace

Result<TrajectoryPtr, Refusal> follow(const arm::ArmModel& arm, const arm::JointVector& start,
                                      const TimedCurve& timed, const Setting& setting) {
  const Trapezoid& profile = timed.profile;
  if (auto too_long = checkDuration(profile.duration())) {
    return refuse(std::move(*too_long));
  }
  PathPostures postures(arm, timed.curve, setting.tcp, arm::poseBitsOf(arm, start));
  if (profile.duration() == 0.0) {
    return TrajectoryPtr(std::make_shared<PathTrajectory>(start, std::move(postures), profile,
                                                          FollowedPath{{start}, kSamplePeriod, start}));
  }
  auto followed =
      checkPath({postures, profile, timed.name, timed.speed, setting.base, setting.speed_override}, start);
  if (!followed) {
    return refuse(std::move(followed.error()));
  }
  return TrajectoryPtr(
      std::make_shared<PathTrajectory>(start, std::move(postures), profile, std::move(*followed)));
}

arm::Pose tcpInRobotBase(const arm::ArmModel& arm, const arm::JointVector& joints, const Setting& setting) {
  return arm::forwardKinematics(arm, joints) * setting.tcp;
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

}  // namespace cobot_command::motion
