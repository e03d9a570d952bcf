// Requests and answers for the reference of 100 %, the defaults of moves and the software joint limits (SRCI:
// ReferenceDynamics, DefaultDynamics, RobotSWLimits).
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::command {

/// SRCI numbers.
namespace dynamics_error {
inline constexpr int kDefaultDynamics = 0x8D07;    ///< a default is out of its range
inline constexpr int kReferenceDynamics = 0x8D25;  ///< no reference: the arm model is unknown
inline constexpr int kLimitsInvalid = 0x8D15;
inline constexpr int kLimitsWhileMoving = 0x8C53;
inline constexpr int kOutsideLimits = 0x8C54;
}  // namespace dynamics_error

/// The values that correspond to 100 %.
struct ReferenceDynamics {
  arm::JointVector joint_speeds = arm::JointVector::Zero();  ///< PTP [rad/s]
  double tcp_speed = 0;                                      ///< Line and Circle [m/s]
  double turn_speed = 0;                                     ///< rotations of Line and Circle [rad/s]
};

/// The joint limits of every plan.
struct SoftwareLimits {
  arm::JointVector lower = arm::JointVector::Zero();  ///< [rad]
  arm::JointVector upper = arm::JointVector::Zero();  ///< [rad]
};

[[nodiscard]] SoftwareLimits limitsOf(const arm::ArmModel& arm);
/// Error of the first invalid joint, in words: the limits must be within those of the model.
[[nodiscard]] std::optional<std::string> faultIn(const SoftwareLimits& limits, const SoftwareLimits& model);

struct DynamicsAnswer {
  bool success = false;  ///< false: nothing has changed
  int error_id = 0;
  std::string message;  ///< in plain words
};

struct LimitsReport {
  SoftwareLimits rule;   ///< limits that apply to every plan
  SoftwareLimits model;  ///< limits of the model; `rule` is never wider
};

}  // namespace cobot_command::command
