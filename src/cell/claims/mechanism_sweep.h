// The pieces of one mechanism's program, without what they claim.
#pragma once

#include <string>

#include "cobot_command/cell/claims/claims.h"

namespace cobot_command::cell {

/// A fault is a sentence: its shapes cannot be made of capsules.
[[nodiscard]] Result<RobotClaim, std::string> piecesOfMechanism(const Parameters& parameters,
                                                                const Mechanism& mechanism);

}  // namespace cobot_command::cell
