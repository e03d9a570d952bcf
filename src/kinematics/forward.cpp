#include "cobot_command/kinematics/forward.h"

#include "question_checks.h"
#include "rounding.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::kinematics {
namespace {

Refusal outsideLimits(const arm::ArmModel& arm, int joint, double given_deg) {
  const arm::JointLimit& limit = arm.limits()[static_cast<std::size_t>(joint)];
  return {
      kinematics_error::kOutsideLimits,
      fmt::format("joint {} is at {:.3f} degrees; allowed: {:.3f} to {:.3f}. Give joints within the limits",
                  joint + 1, given_deg, radToDeg(limit.lower), radToDeg(limit.upper))};
}

}  // namespace

Result<ForwardAnswer, Refusal> forward(const arm::ArmModel& arm, const tables::DataTables& tables,
                                       const ForwardQuestion& question) {
  const auto joints = finiteJoints(question.joints);
  if (!joints) return refuse(joints.error());
  const auto mounting = mountingOf(tables, question.numbers);
  if (!mounting) return refuse(mounting.error());
  const int outside = arm.firstJointOutsideLimits(*joints);
  if (outside >= 0) {
    return refuse(outsideLimits(arm, outside, question.joints[static_cast<std::size_t>(outside)]));
  }
  const arm::Pose pose = mounting->frame.inverse() * forwardKinematics(arm, *joints) * mounting->tool;
  return ForwardAnswer{shown(arm::toControllerPose(pose)), postureOf(*joints, poseBitsOf(arm, *joints))};
}

}  // namespace cobot_command::kinematics
