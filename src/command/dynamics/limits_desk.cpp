#include "dynamics/limits_desk.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"
#include "cobot_command/robot/same_values.h"

namespace cobot_command::command {
namespace {

/// Of degrees that were made radians and back [rad].
constexpr double kRounding = 1e-6;

}  // namespace

SoftwareLimits limitsOf(const arm::ArmModel& arm) {
  SoftwareLimits limits;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    limits.lower[static_cast<Eigen::Index>(i)] = arm.limits()[i].lower;
    limits.upper[static_cast<Eigen::Index>(i)] = arm.limits()[i].upper;
  }
  return limits;
}

std::optional<std::string> faultIn(const SoftwareLimits& limits, const SoftwareLimits& model) {
  for (Eigen::Index i = 0; i < limits.lower.size(); ++i) {
    const double lower = limits.lower[i];
    const double upper = limits.upper[i];
    const bool is_within = lower >= model.lower[i] - kRounding && upper <= model.upper[i] + kRounding;
    if (is_within && upper - lower > 2 * kRounding) continue;  // false for NaN too
    return fmt::format(
        "the limits of J{} are {:.6g} and {:.6g} deg, allowed: the lower one below the upper one, and both "
        "within those of the model, {:.6g} to {:.6g} deg",
        i + 1, radToDeg(lower), radToDeg(upper), radToDeg(model.lower[i]), radToDeg(model.upper[i]));
  }
  return std::nullopt;
}

std::optional<LimitsReport> LimitsDesk::limits() const {
  if (forecast_.arm() == nullptr) return std::nullopt;
  return LimitsReport{limitsOf(*forecast_.limitedArm()), limitsOf(*forecast_.arm())};
}

DynamicsAnswer LimitsDesk::write(const SoftwareLimits& limits, bool under_way) {
  const arm::ArmModel* const arm = forecast_.arm();
  if (arm == nullptr) {
    return {false, blocks::own_error::kNoModel,
            "there is no model of the arm: nothing is planned, and nothing can be limited"};
  }
  const SoftwareLimits model = limitsOf(*arm);
  if (const auto fault = faultIn(limits, model)) {
    return {false, dynamics_error::kLimitsInvalid, *fault + "; the previous limits remain in effect"};
  }
  if (under_way || robot_.moving().value_or(false)) {
    return {false, dynamics_error::kLimitsWhileMoving,
            "a goal is running or queued, or the robot moves: set the limits when the robot is at standstill "
            "and no goal is queued; a stop ends all goals"};
  }
  auto limited = std::make_shared<const arm::ArmModel>(
      arm->limitedTo(limits.lower.cwiseMax(model.lower), limits.upper.cwiseMin(model.upper)));
  const auto joints = robot_.joints();
  if (const int joint = joints ? limited->firstJointOutsideLimits(*joints) : -1; joint >= 0) {
    return {false, dynamics_error::kOutsideLimits,
            fmt::format("J{} is at {:.3f} deg, outside of {:.6g} to {:.6g} deg: move it there first",
                        joint + 1, radToDeg((*joints)[joint]), radToDeg(limits.lower[joint]),
                        radToDeg(limits.upper[joint]))};
  }
  forecast_.useLimits(limited);
  actions_.emplace_back(SoftwareLimitsChanged{std::move(limited)});
  return {true, 0,
          joints ? "they apply to every plan from now on"
                 : "they apply to every plan from now on; the position of the robot is unknown"};
}

std::optional<ReferenceDynamics> LimitsDesk::reference() const {
  const arm::ArmModel* const arm = forecast_.arm();
  if (arm == nullptr) return std::nullopt;
  ReferenceDynamics reference;
  for (std::size_t i = 0; i < arm::kJointCount; ++i) {
    reference.joint_speeds[static_cast<Eigen::Index>(i)] = arm->limits()[i].max_velocity;
  }
  reference.tcp_speed = arm->ratings().max_tcp_speed;
  reference.turn_speed = arm->ratings().turn_speed;
  return reference;
}

void LimitsDesk::see(const link::RobotStatus& status) {
  if (status.safety_lower && status.safety_upper) theirs_ = {*status.safety_lower, *status.safety_upper};
}

std::string LimitsDesk::excess() const {
  if (!areCompared()) return "";
  const SoftwareLimits ours = limitsOf(*forecast_.limitedArm());
  std::string text;
  for (Eigen::Index i = 0; i < ours.lower.size(); ++i) {
    const bool is_inside = ours.lower[i] >= theirs_->lower[i] - robot::same::kAngle &&
                           ours.upper[i] <= theirs_->upper[i] + robot::same::kAngle;
    if (is_inside) continue;
    const bool is_none = theirs_->lower[i] >= theirs_->upper[i];
    text += fmt::format(
        "{}the controller's safety functions limit J{} to {:.6g}..{:.6g} deg{}, and this node plans it "
        "within {:.6g}..{:.6g} deg",
        text.empty() ? "" : "; ", i + 1, radToDeg(theirs_->lower[i]), radToDeg(theirs_->upper[i]),
        is_none ? ", which are no limits: if the controller has none, do not enable software_limits" : "",
        radToDeg(ours.lower[i]), radToDeg(ours.upper[i]));
  }
  return text;
}

}  // namespace cobot_command::command
