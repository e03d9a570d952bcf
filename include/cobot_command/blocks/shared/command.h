// One script that a run wants to send, with all data about it; the same type for every block.
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

/// Identifies a command within its run; chosen by the run.
using CommandKey = std::uint64_t;

struct Command {
  CommandKey key = 0;
  Block block{};  ///< block that has the errors of the command
  GoalTraits traits;
  /// The lines of the script, if the active base is `base` in the robot base.
  std::function<Order(const arm::Pose& base)> order;
  /// Why the command must not be sent because a target in a tf frame has moved. Empty function: it has no
  /// such target.
  std::function<std::optional<Failure>(const FrameFinder& finder)> find_moved_frame;
  bool leaves_only = false;  ///< it only leaves the Listen node: done if the node was left already
};

}  // namespace cobot_command::blocks
