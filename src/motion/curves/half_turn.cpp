#include "curves/half_turn.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

bool isAmbiguous(double turn, const Setting& setting) {
  return std::abs(kPi - turn) < setting.start_tolerance;
}

Refusal refusal(int joint, const arm::Pose& point, std::string message) {
  return {Refusal::Reason::AmbiguousTurn, 1.0, joint, point, std::move(message)};
}

bool canBeAt(const arm::ArmModel& arm, arm::JointVector posture, Eigen::Index joint, double angle) {
  posture[joint] = angle;
  return arm.firstJointOutsideLimits(posture) < 0;
}

}  // namespace

std::optional<Refusal> ambiguousTurn(double turn, const arm::Pose& to, const char* name,
                                     const Setting& setting) {
  if (!isAmbiguous(turn, setting)) {
    return std::nullopt;
  }
  return refusal(-1, setting.base.inverse() * to,
                 fmt::format("the {} turns the TCP by {:.2f} deg, and half a turn (to {:.1f} deg) can be "
                             "made in either direction: add an intermediate point at which the TCP has made "
                             "part of the turn, or use PTP to joints",
                             name, radToDeg(turn), radToDeg(setting.start_tolerance)));
}

std::optional<Refusal> ambiguousPosture(const arm::ArmModel& arm, const arm::JointVector& start,
                                        const arm::JointVector& target, const arm::Pose& point,
                                        const Setting& setting) {
  for (Eigen::Index i = 0; i < target.size(); ++i) {
    const double way = target[i] - start[i];
    if (!isAmbiguous(std::abs(way), setting)) {
      continue;
    }
    const double other = target[i] - std::copysign(2.0 * kPi, way);
    if (!canBeAt(arm, target, i, other)) {
      continue;
    }
    return refusal(
        static_cast<int>(i), point,
        fmt::format(
            "J{} turns by {:.2f} deg to {:.2f} deg, and reaches the same pose by half a turn (to {:.1f} deg) "
            "in the other direction, to {:.2f} deg: give the target as joints, or add an intermediate point",
            i + 1, radToDeg(way), radToDeg(target[i]), radToDeg(setting.start_tolerance), radToDeg(other)));
  }
  return std::nullopt;
}

}  // namespace cobot_command::motion
