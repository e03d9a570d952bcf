// The controller's Error_Code for a motion that cannot be made (TM 2.6).
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::simulator {

struct RobotError {
  int code = 0;
  std::string text;  ///< for Error_Content and the log
};

/// The mapping is ours where only the codes are known; see doc/simulator.md. `reaches_end`: the
/// arm could be where the motion ends.
[[nodiscard]] RobotError robotErrorFor(const motion::Refusal& refusal, bool reaches_end);

/// Why the arm does not move with these masses [kg]: one is below 0, or they are more than the model carries.
[[nodiscard]] std::optional<RobotError> overload(const arm::ArmModel& arm, double tool, double load);

}  // namespace cobot_command::simulator
