// The gate: asked before the first byte of a frame that may move the robot, or lets its project go on.
// Default: open.
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
  blocks::Block block{};           ///< whose errors a refusal is one of
  std::vector<std::string> lines;  ///< without queue tag, and without the exit from the node behind them
  bool asks_permit = false;        ///< it is a frame of a run_program goal
  bool planned = false;            ///< false: nobody knows what the lines do
  std::vector<motion::TrajectoryPtr> motions;  ///< of planned ones, in their order
  std::optional<arm::JointVector> start;       ///< where what is in front of it leaves the arm [rad]
  arm::Pose tcp = arm::Pose::Identity();       ///< of the motions, in the flange [m]
  std::optional<arm::Pose> base;               ///< active behind them, in the robot base [m]
  /// The Listen node is left with it, or behind it: the project goes on then, and may move the arm too.
  bool leaves_node = false;
};

/// Why it must not leave now; nothing: it may. Asked in the core's thread, in the event in which the frame
/// would leave: what it says holds for that instant, and is no promise that the frame leaves. Not asked are a
/// stop, a pause, outputs and settings; nor is a RESUME of program_control, as what it lets go on has passed
/// the gate, or was there before. Precondition of a refusal: the tables of that block have its id.
using Gate = std::function<std::optional<blocks::Failure>(const Departure& departure, Instant now)>;

}  // namespace cobot_command::command
