#include "kinds/ramped_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "curves/circle_path.h"
#include "curves/half_turn.h"
#include "curves/tcp_path.h"
#include "kinds/joint_trajectory.h"
#include "paths/input_check.h"
#include "paths/path_trajectory.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

/// Below this [m and rad] there is nothing to move.
constexpr double kNoWay = 1e-9;
/// A joint at its rated speed is not above it.
constexpr double kRounding = 1e-9;
/// The same of joints, 1e-6 degrees [rad].
constexpr double kNoJointWay = degToRad(1e-6);

/// As fast as time runs.
Rates scaled(const Rates& rates, double by) {
  return {rates.speed * by, rates.acceleration * by * by, rates.deceleration * by * by};
}

/// The same rates of a progress from 0 to 1 over `way`; without a way they hold nothing back.
Rates ofProgress(const Rates& rates, double way) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (way < kNoWay) return {kNone, kNone, kNone};
  return {rates.speed / way, rates.acceleration / way, rates.deceleration / way};
}

Rates slower(const Rates& a, const Rates& b) {
  return {std::min(a.speed, b.speed), std::min(a.acceleration, b.acceleration),
          std::min(a.deceleration, b.deceleration)};
}

ProfilePtr profileOver(double way, const Rates& rates, const RampShape& ramps, bool moves) {
  const Phases phases = moves ? onGrid(phasesOf(way, rates, ramps)) : Phases{};
  return std::make_shared<const RampedProfile>(phases, ramps);
}

Refusal tooFast(const arm::ArmModel& arm, const arm::JointVector& way, double speed, const Setting& setting,
                const arm::JointVector& target) {
  const double longest = way.cwiseAbs().maxCoeff();
  double usable = std::numeric_limits<double>::infinity();
  int joint = 0;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const double share = std::abs(way[static_cast<Eigen::Index>(i)]) / longest;
    const double allowed = arm.limits()[i].max_velocity / share;
    if (allowed < usable) {
      usable = allowed;
      joint = static_cast<int>(i);
    }
  }
  const double rated = arm.limits()[static_cast<std::size_t>(joint)].max_velocity;
  return {Refusal::Reason::JointSpeed, 1.0, joint,
          setting.base.inverse() * arm::forwardKinematics(arm, target) * setting.tcp,
          fmt::format("J{} would need {:.2f} deg/s, rated {:.1f} deg/s; at most {:.1f} deg/s of the joint "
                      "with the longest travel is possible: choose a lower speed",
                      joint + 1, radToDeg(speed * std::abs(way[joint]) / longest), radToDeg(rated),
                      std::floor(10.0 * radToDeg(usable / setting.speed_override) + 1e-6) / 10.0)};
}

Result<TrajectoryPtr, Refusal> along(const arm::ArmModel& arm, const arm::JointVector& start,
                                     const TcpPath& path, const PathRates& rates, const char* name,
                                     const Setting& setting) {
  if (auto ambiguous = ambiguousTurn(path.turn(), path.at(1.0), name, setting)) {
    return refuse(std::move(*ambiguous));
  }
  ProfilePtr profile = profileOf(path.length(), path.turn(), rates, setting.speed_override);
  const AskedSpeed asked =
      askedSpeed(path.length(), path.turn(), rates, profile->travel() * setting.speed_override);
  return follow(arm, start, {std::make_shared<const TcpPath>(path), std::move(profile), name, asked},
                setting);
}

}  // namespace

ProfilePtr profileOf(double length, double turn, const PathRates& rates, double speed_override) {
  const Rates both = slower(ofProgress(scaled(rates.way, speed_override), length),
                            ofProgress(scaled(rates.turn, speed_override), turn));
  return profileOver(1.0, both, rates.ramps, length >= kNoWay || turn >= kNoWay);
}

AskedSpeed askedSpeed(double length, double turn, const PathRates& rates, double travel) {
  constexpr const char* kOtherwise = "choose another path, or PTP";
  const bool turn_rules = turn * rates.way.speed > length * rates.turn.speed;
  return turn_rules ? AskedSpeed{radToDeg(std::min(rates.turn.speed, turn / travel)), "deg/s", kOtherwise}
                    : AskedSpeed{mToMm(std::min(rates.way.speed, length / travel)), "mm/s", kOtherwise};
}

Result<TrajectoryPtr, Refusal> planJointMove(const arm::ArmModel& arm, const arm::JointVector& start,
                                             const JointMove& move, const Setting& setting) {
  if (auto outside = targetOutsideLimits(arm, move.target, setting)) return refuse(std::move(*outside));
  const arm::JointVector way = move.target - start;
  const double longest = way.cwiseAbs().maxCoeff();
  ProfilePtr profile =
      profileOver(longest, scaled(move.rates, setting.speed_override), move.ramps, longest >= kNoJointWay);
  if (auto too_long = checkDuration(profile->duration())) return refuse(std::move(*too_long));
  const double top = profile->duration() > 0.0 ? longest / profile->travel() : 0.0;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    const double needed = top * std::abs(way[static_cast<Eigen::Index>(i)]) / longest;
    if (needed > arm.limits()[i].max_velocity * (1.0 + kRounding)) {
      return refuse(tooFast(arm, way, top, setting, move.target));
    }
  }
  return TrajectoryPtr(std::make_shared<JointTrajectory>(start, move.target, std::move(profile)));
}

Result<TrajectoryPtr, Refusal> planStraightMove(const arm::ArmModel& arm, const arm::JointVector& start,
                                                const StraightMove& move, const Setting& setting) {
  const TcpPath path = TcpPath::line(tcpInRobotBase(arm, start, setting), setting.base * move.target);
  return along(arm, start, path, move.rates, "line", setting);
}

Result<TrajectoryPtr, Refusal> planArcMove(const arm::ArmModel& arm, const arm::JointVector& start,
                                           const ArcMove& move, const Setting& setting) {
  const arm::Pose from = tcpInRobotBase(arm, start, setting);
  Circle circle;
  circle.via = setting.base * move.via;
  circle.end = setting.base * move.target;
  auto path = circlePath(from, circle);
  if (!path) {
    return refuse(Refusal{Refusal::Reason::DegenerateCircle, 0.0, -1, setting.base.inverse() * from,
                          std::move(path.error().message)});
  }
  return along(arm, start, *path, move.rates, "arc", setting);
}

}  // namespace cobot_command::motion
