#include "cobot_command/motion/velocity.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "curves/twist_path.h"
#include "kinds/joint_velocity.h"
#include "paths/input_check.h"
#include "paths/path_check.h"
#include "paths/path_trajectory.h"
#include "profiles/trapezoid.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

Refusal refusal(Refusal::Reason reason, std::string message) {
  Refusal made;
  made.reason = reason;
  made.message = std::move(message);
  return made;
}

/// Of the TCP in the robot base.
PathRate tcpRate(const arm::ArmModel& arm, const JointState& state, const Setting& setting) {
  PathRate rate = arm::jacobianAt(arm, state.position) * state.velocity;
  const Eigen::Vector3d flange_to_tcp =
      arm::forwardKinematics(arm, state.position).linear() * setting.tcp.translation();
  rate.head<3>() += rate.tail<3>().cross(flange_to_tcp);
  return rate;
}

class TcpVelocityPlan {
 public:
  TcpVelocityPlan(const arm::ArmModel& arm, const JointState& now, const PathRate& velocity,
                  const VelocityTimes& times, const Setting& setting)
      : arm_(arm),
        now_(now),
        from_(tcpRate(arm, now, setting)),
        velocity_(velocity),
        times_(times),
        setting_(setting) {}

  /// For as long as it was asked for, or until shortly before what is in the way.
  [[nodiscard]] Result<VelocityMotion, Refusal> make() const {
    auto whole = with(times_.steady);
    if (whole) return VelocityMotion{std::move(*whole), {}};
    auto best = with(0.0);
    if (!best) return refuse(std::move(best.error()));
    VelocityMotion made{std::move(*best), std::move(whole.error())};
    constexpr double kFine = 1e-3;  // [s]
    double good = 0.0;
    double bad = times_.steady;
    while (bad - good > kFine) {
      const double middle = 0.5 * (good + bad);
      if (auto longer = with(middle)) {
        made.trajectory = std::move(*longer);
        good = middle;
      } else {
        made.ends_at = std::move(longer.error());
        bad = middle;
      }
    }
    return made;
  }

 private:
  [[nodiscard]] Result<TrajectoryPtr, Refusal> with(double steady) const {
    const auto path = std::make_shared<TwistPath>(tcpInRobotBase(arm_, now_.position, setting_));
    path->append(times_.ramp, from_, velocity_);
    path->append(steady, velocity_);
    path->append(times_.ramp, velocity_, PathRate::Zero());
    return follow(arm_, now_.position,
                  {path, std::make_shared<const Trapezoid>(Trapezoid::steady(path->duration())), "way", {}},
                  setting_);
  }

  const arm::ArmModel& arm_;
  const JointState& now_;
  PathRate from_;
  PathRate velocity_;
  VelocityTimes times_;
  const Setting& setting_;
};

Result<VelocityMotion, Refusal> planTcpVelocity(const arm::ArmModel& arm, const JointState& now,
                                                const TcpVelocity& velocity, const VelocityTimes& times,
                                                const Setting& setting) {
  if (velocity.linear.norm() > kMaxTcpSpeed) {
    return refuse(refusal(Refusal::Reason::BadParameter,
                          fmt::format("the requested speed of the TCP is {:.6g} mm/s, at most {:.0f} mm/s is "
                                      "allowed: choose a lower speed",
                                      mToMm(velocity.linear.norm()), mToMm(kMaxTcpSpeed))));
  }
  PathRate rate;
  rate << setting.base.linear() * velocity.linear, setting.base.linear() * velocity.angular;
  return TcpVelocityPlan(arm, now, rate * setting.speed_override, times, setting).make();
}

bool isFinite(const SetVelocity& set) {
  return std::visit(
      Overloaded{[](const arm::JointVector& joints) { return joints.allFinite(); },
                 [](const TcpVelocity& tcp) { return tcp.linear.allFinite() && tcp.angular.allFinite(); }},
      set.velocity);
}

}  // namespace

Result<VelocityMotion, Refusal> planVelocity(const arm::ArmModel& arm, const JointState& now,
                                             const SetVelocity& set, const Setting& setting) {
  if (!isFinite(set)) {
    return refuse(refusal(Refusal::Reason::NotFinite,
                          "the velocity is not finite (NaN or infinite): give finite numbers"));
  }
  const double ramp = std::max(toSeconds(set.ramp), kSamplePeriod);
  const double lasting = toSeconds(std::min(set.lasting.value_or(kMaxLasting), kMaxLasting));
  const VelocityTimes times{ramp, std::max(0.0, lasting - ramp)};
  return std::visit(
      Overloaded{[&](const arm::JointVector& joints) {
                   return planJointVelocity(arm, now, joints * setting.speed_override, times, setting);
                 },
                 [&](const TcpVelocity& tcp) { return planTcpVelocity(arm, now, tcp, times, setting); }},
      set.velocity);
}

}  // namespace cobot_command::motion
