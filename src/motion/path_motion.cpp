#include "path_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "circle_path.h"
#include "input_check.h"
#include "path_check.h"
#include "path_postures.h"
#include "rest_to_rest.h"
#include "tcp_path.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::motion {
namespace {

/// A path shorter than this [m and rad] is none.
constexpr double kNoWay = 1e-9;

class PathTrajectory final : public RestToRest {
 public:
  PathTrajectory(const arm::JointVector& start, PathPostures postures, const Trapezoid& profile,
                 FollowedPath followed)
      : RestToRest(start, followed.end, profile),
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

/// The time [s] that the path takes at top speed: of its way and of its turn the slower one.
double timeAtTopSpeed(const arm::ArmModel& arm, const TcpPath& path, const PathSpeed& speed,
                      double speed_override) {
  const double full = arm.ratings().max_tcp_speed;
  const auto* ratio = std::get_if<SpeedRatio>(&speed);
  const double linear = ratio ? ratio->value * full : std::get<TcpSpeed>(speed).metres_per_second;
  const double angular = std::min(1.0, linear / full) * kFullTurnSpeed;
  return std::max(path.length() / linear, path.turn() / angular) / speed_override;
}

struct Request {
  const char* name;
  const PathSpeed& speed;
  Duration time_to_top_speed;
};

Result<TrajectoryPtr, Refusal> planPath(const arm::ArmModel& arm, const arm::JointVector& start,
                                        const TcpPath& path, const Request& request, const Setting& setting) {
  const bool stands = path.length() < kNoWay && path.turn() < kNoWay;
  const double travel = stands ? 0.0 : timeAtTopSpeed(arm, path, request.speed, setting.speed_override);
  const Trapezoid profile(travel, toSeconds(request.time_to_top_speed));
  if (auto too_long = checkDuration(profile.duration())) {
    return refuse(std::move(*too_long));
  }
  PathPostures postures(arm, path, setting.tcp, arm::poseBitsOf(arm, start));
  if (profile.duration() == 0.0) {
    return TrajectoryPtr(std::make_shared<PathTrajectory>(start, std::move(postures), profile,
                                                          FollowedPath{{start}, kSamplePeriod, start}));
  }
  auto followed = checkPath({postures, profile, request.name, request.speed, setting.base}, start);
  if (!followed) {
    return refuse(std::move(followed.error()));
  }
  return TrajectoryPtr(
      std::make_shared<PathTrajectory>(start, std::move(postures), profile, std::move(*followed)));
}

arm::Pose startTcp(const arm::ArmModel& arm, const arm::JointVector& start, const Setting& setting) {
  return arm::forwardKinematics(arm, start) * setting.tcp;
}

}  // namespace

Result<TrajectoryPtr, Refusal> planLine(const arm::ArmModel& arm, const arm::JointVector& start,
                                        const Line& line, const Setting& setting) {
  const TcpPath path = TcpPath::line(startTcp(arm, start, setting), setting.base * line.target);
  return planPath(arm, start, path, {"line", line.speed, line.time_to_top_speed}, setting);
}

Result<TrajectoryPtr, Refusal> planCircle(const arm::ArmModel& arm, const arm::JointVector& start,
                                          const Circle& circle, const Setting& setting) {
  Circle in_robot_base = circle;
  in_robot_base.via = setting.base * circle.via;
  in_robot_base.end = setting.base * circle.end;
  const arm::Pose from = startTcp(arm, start, setting);
  auto path = circlePath(from, in_robot_base);
  if (!path) {
    return refuse(Refusal{Refusal::Reason::DegenerateCircle, 0.0, -1, setting.base.inverse() * from,
                          std::move(path.error().message)});
  }
  return planPath(arm, start, *path, {"circle", circle.speed, circle.time_to_top_speed}, setting);
}

}  // namespace cobot_command::motion
