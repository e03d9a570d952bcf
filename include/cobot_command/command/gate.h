// The gate: called before the first byte of a frame that may move the robot or let its project continue.
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

/// The frame that is about to be sent.
struct Departure {
  blocks::Block block{};           ///< block that has the error of a refusal
  std::vector<std::string> lines;  ///< without queue tag, and without the exit from the node after them
  bool asks_permit = false;        ///< it is a frame of a run_program goal
  bool planned = false;            ///< false: the effect of the lines is unknown
  std::vector<motion::TrajectoryPtr> motions;  ///< of a planned frame, in their order
  std::optional<arm::JointVector> start;       ///< where the preceding commands leave the arm [rad]
  arm::Pose tcp = arm::Pose::Identity();       ///< of the motions, in the flange [m]
  std::optional<arm::Pose> base;               ///< active after the motions, in the robot base [m]
  /// The Listen node is left with or after this frame: the project then continues, and may move the arm too.
  bool leaves_node = false;
};

/// Why the frame must not be sent now; nullopt: it may be sent. Called on the core's thread, in the event in
/// which the frame would be sent. The answer is valid for that instant, and does not mean that the frame is
/// sent. Not called for a stop, a pause, outputs and settings; nor for a RESUME of program_control, because
/// the resumed commands have passed the gate already, or existed before. Precondition of a refusal: the error
/// table of that block has its id.
using Gate = std::function<std::optional<blocks::Failure>(const Departure& departure, Instant now)>;

}  // namespace cobot_command::command
