// What is in the way of a jog, as its end and for people.
#pragma once

#include "cobot_command/blocks/jog.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::blocks {

/// Of what a plan has found.
[[nodiscard]] JogEnd jogEndOf(const motion::Refusal& obstacle);
/// Of a move that could not be planned; None: it is refused for what is not in the way.
[[nodiscard]] JogEnd jogEndOf(int error_id);
/// What to do.
[[nodiscard]] const char* wayOutOf(JogEnd end);

}  // namespace cobot_command::blocks
