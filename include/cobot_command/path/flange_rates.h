// Speed and acceleration of the flange on a planned path.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// Absolute values, for the origin and the rotation.
struct FlangeRates {
  double linear_velocity = 0;       ///< [m/s]
  double linear_acceleration = 0;   ///< tangential and centripetal together [m/s^2]
  double angular_velocity = 0;      ///< [rad/s]
  double angular_acceleration = 0;  ///< [rad/s^2]
};

/// Zero before and after the plan.
[[nodiscard]] FlangeRates flangeRatesAt(const PathPlan& plan, Duration time, const arm::ArmModel& arm);

}  // namespace cobot_command::path
