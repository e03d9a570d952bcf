// How fast the flange goes along a planned path.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/time.h"
#include "cobot_command/path/path_plan.h"

namespace cobot_command::path {

/// Absolute values, of its origin and of its turn.
struct FlangeRates {
  double linear_velocity = 0;       ///< [m/s]
  double linear_acceleration = 0;   ///< along its way and across it [m/s^2]
  double angular_velocity = 0;      ///< [rad/s]
  double angular_acceleration = 0;  ///< [rad/s^2]
};

/// At rest before the plan, and behind it.
[[nodiscard]] FlangeRates flangeRatesAt(const PathPlan& plan, Duration time, const arm::ArmModel& arm);

}  // namespace cobot_command::path
