// The gate: asked before the first byte of a frame that may move the robot. Default: open.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::command {

/// What is about to leave.
struct Departure {
  blocks::Block block{};  ///< whose errors a refusal is one of
  std::vector<std::string> lines;
  bool planned = false;                        ///< false: nobody knows what the lines do
  std::vector<motion::TrajectoryPtr> motions;  ///< of a planned one, in their order
  arm::Pose tcp = arm::Pose::Identity();       ///< of them, in the flange [m]
};

/// Why it must not leave now; nothing: it may. Asked in the core's thread, in the event in which the frame
/// would leave: what it says holds for that instant. What can only take motion away (a stop, a pause), and
/// what goes out beside motions, is not asked for. Precondition of a refusal: the tables of that block have
/// its id.
using Gate = std::function<std::optional<blocks::Failure>(const Departure& departure, Instant now)>;

}  // namespace cobot_command::command
