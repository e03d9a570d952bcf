// Converts the refusal of a motion into an error of the catalogue.
#pragma once

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::blocks {

[[nodiscard]] Failure toFailure(const motion::Refusal& refusal);

}  // namespace cobot_command::blocks
