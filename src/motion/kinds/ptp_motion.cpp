#include "kinds/ptp_motion.h"

#include <cmath>
#include <utility>

#include "curves/half_turn.h"
#include "kinds/joint_trajectory.h"
#include "paths/input_check.h"
#include "profiles/ramp_time.h"
#include "profiles/trapezoid.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

Refusal::Reason reasonFor(arm::IkRefusal::Reason reason) {
  switch (reason) {
    case arm::IkRefusal::Reason::NotFinite:
      return Refusal::Reason::NotFinite;
    case arm::IkRefusal::Reason::OutOfReach:
      return Refusal::Reason::Unreachable;
    case arm::IkRefusal::Reason::BitsNotPossible:
      return Refusal::Reason::PoseBits;
    case arm::IkRefusal::Reason::OutsideLimits:
      return Refusal::Reason::JointLimit;
  }
  return Refusal::Reason::Unreachable;
}

Result<arm::JointVector, Refusal> postureAt(const PoseTarget& target, const arm::ArmModel& arm,
                                            const arm::JointVector& start, const Setting& setting) {
  const arm::Pose flange = setting.base * target.pose * setting.tcp.inverse();
  const arm::PoseBits bits = target.bits ? *target.bits : arm::poseBitsOf(arm, start);
  auto posture = arm::postureFor(arm, flange, bits, start);
  if (!posture) {
    arm::IkRefusal& why = posture.error();
    return refuse(Refusal{reasonFor(why.reason), 1.0, why.joint, target.pose, std::move(why.message)});
  }
  if (auto ambiguous = ambiguousPosture(arm, start, *posture, target.pose, setting)) {
    return refuse(std::move(*ambiguous));
  }
  return *posture;
}

Result<arm::JointVector, Refusal> postureAt(const arm::JointVector& target, const arm::ArmModel& arm,
                                            const arm::JointVector& /*start*/, const Setting& setting) {
  if (auto outside = targetOutsideLimits(arm, target, setting)) return refuse(std::move(*outside));
  return target;
}

/// The time [s] that the slowest joint needs at its rated speed.
double timeAtRatedSpeed(const arm::ArmModel& arm, const arm::JointVector& way) {
  double longest = 0.0;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    longest = std::max(longest, std::abs(way[static_cast<Eigen::Index>(i)]) / arm.limits()[i].max_velocity);
  }
  return longest;
}

}  // namespace

Result<TrajectoryPtr, Refusal> planPtp(const arm::ArmModel& arm, const arm::JointVector& start,
                                       const Ptp& ptp, const Setting& setting) {
  auto target =
      std::visit([&](const auto& kind) { return postureAt(kind, arm, start, setting); }, ptp.target);
  if (!target) {
    return refuse(std::move(target.error()));
  }
  const double travel = timeAtRatedSpeed(arm, *target - start) / (ptp.speed_ratio * setting.speed_override);
  auto profile = std::make_shared<const Trapezoid>(travel, rampTime(ptp.time_to_top_speed, ptp.speed_ratio));
  if (auto too_long = checkDuration(profile->duration())) {
    return refuse(std::move(*too_long));
  }
  return TrajectoryPtr(std::make_shared<JointTrajectory>(start, *target, std::move(profile)));
}

}  // namespace cobot_command::motion
