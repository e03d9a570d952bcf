// What stands for an arm whose model nobody has said.
#pragma once

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

/// Each joint goes as far as that of any known model, and as fast: whatever arm it is, a share of these
/// speeds is no faster on it, if it is a known one. Where its flange is means nothing.
[[nodiscard]] const ArmModel& anyArm();

}  // namespace cobot_command::arm
