// One script that a run wants sent, with all that has to be known of it; the same for every block.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_traits.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/order.h"

namespace cobot_command::blocks {

/// By which a run tells its commands apart; of its own choosing.
using CommandKey = std::uint64_t;

struct Command {
  CommandKey key = 0;
  Block block{};  ///< whose errors it fails with
  GoalTraits traits;
  /// Its lines, when the active base is `base` in the robot base.
  std::function<Order(const arm::Pose& base)> order;
  /// Why it must not be sent, as a target in a tf frame has moved; may be empty: it has none.
  std::function<std::optional<Failure>(const FrameFinder& finder)> find_moved_frame;
  bool leaves_only = false;  ///< it is to leave the Listen node: done, when that was left already
};

}  // namespace cobot_command::blocks
