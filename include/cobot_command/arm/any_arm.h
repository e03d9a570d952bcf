// A substitute for an arm whose model is not configured.
#pragma once

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

/// An arm with the widest joint limits and the highest joint speeds of all known models. At the same speed
/// ratio no known model is faster than this one. Its flange pose has no meaning.
[[nodiscard]] const ArmModel& anyArm();

}  // namespace cobot_command::arm
