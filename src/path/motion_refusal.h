// The numbers of the manual for what motion/ refuses.
#pragma once

#include <string>

#include "cobot_command/motion/refusal.h"

namespace cobot_command::path {

/// 1037, 1045 to 1048, 16#204; all else is 16#206.
[[nodiscard]] int errorIdOf(motion::Refusal::Reason reason);

/// What is said behind a refusal for a speed or a time, as it is of that feedrate; empty: it is of the usual
/// one.
[[nodiscard]] std::string textOfFeedrate(double feedrate);

}  // namespace cobot_command::path
