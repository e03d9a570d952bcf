// What 100 % means, what moves have whose own value is negative, and between which angles joints are planned:
// asked for and answered (SRCI: ReferenceDynamics, DefaultDynamics, RobotSWLimits).
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::command {

/// The numbers of SRCI.
namespace dynamics_error {
inline constexpr int kDefaultDynamics = 0x8D07;    ///< a default that is out of its range
inline constexpr int kReferenceDynamics = 0x8D25;  ///< there are none: no model of the arm is known
inline constexpr int kLimitsInvalid = 0x8D15;
inline constexpr int kLimitsWhileMoving = 0x8C53;
inline constexpr int kOutsideLimits = 0x8C54;
}  // namespace dynamics_error

/// What 100 % are of.
struct ReferenceDynamics {
  arm::JointVector joint_speeds = arm::JointVector::Zero();  ///< PTP [rad/s]
  double tcp_speed = 0;                                      ///< Line and Circle [m/s]
  double turn_speed = 0;                                     ///< the turns of these [rad/s]
};

/// Between which angles every motion is planned.
struct SoftwareLimits {
  arm::JointVector lower = arm::JointVector::Zero();  ///< [rad]
  arm::JointVector upper = arm::JointVector::Zero();  ///< [rad]
};

[[nodiscard]] SoftwareLimits limitsOf(const arm::ArmModel& arm);
/// Of the first joint that is wrong, in words: they have to be within those of the model.
[[nodiscard]] std::optional<std::string> faultIn(const SoftwareLimits& limits, const SoftwareLimits& model);

struct DynamicsAnswer {
  bool success = false;  ///< false: nothing has changed
  int error_id = 0;
  std::string message;  ///< in plain words
};

struct LimitsReport {
  SoftwareLimits rule;   ///< with which every plan is made
  SoftwareLimits model;  ///< never wider than these
};

}  // namespace cobot_command::command
