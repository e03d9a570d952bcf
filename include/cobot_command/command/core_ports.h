// The functions through which the core of a robot gets information during an event.
#pragma once

#include <functional>

#include "cobot_command/blocks/programs/program_guide.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/command/gate.h"
#include "cobot_command/command/waiting_goals.h"
#include "cobot_command/link/connection.h"

namespace cobot_command::command {

/// Each may be empty.
struct CorePorts {
  /// Called for a goal with a target in a frame that has waited; if empty, targets count as unmoved.
  blocks::FrameFinder frames;
  /// Called when commands end because of an event and not of a goal; if empty, the newest submitted goal
  /// counts.
  NewestGoal newest;
  /// Called before a frame that may move the robot is sent; if empty, all frames may be sent.
  Gate gate;
  /// Guides run_program goals; nullptr: the robot is in no cell.
  blocks::ProgramGuidePtr program;
  /// True: the frames of that channel (FrameTraced) have a subscriber; if empty, they always have one.
  std::function<bool(link::Channel channel)> traced;
};

}  // namespace cobot_command::command
