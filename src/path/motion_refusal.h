// The numbers of the manual for what motion/ refuses.
#pragma once

#include "cobot_command/motion/refusal.h"

namespace cobot_command::path {

/// 1037, 1045 to 1048, 16#204; all else is 16#206.
[[nodiscard]] int errorIdOf(motion::Refusal::Reason reason);

}  // namespace cobot_command::path
