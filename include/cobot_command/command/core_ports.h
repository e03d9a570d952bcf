// Whom the core of a robot asks, in the middle of an event.
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
  /// When a goal with a target in a frame has waited; without it, targets stay where they were.
  blocks::FrameFinder frames;
  /// When commands fall by what happens, not by a goal; without it, it is the newest that was submitted.
  NewestGoal newest;
  /// Before a frame leaves that may move the robot; without it, all may.
  Gate gate;
  /// Who leads run_program goals; nullptr: the robot is in no cell.
  blocks::ProgramGuidePtr program;
  /// Whether somebody listens to the frames of that channel (FrameTraced); without it, somebody always does.
  std::function<bool(link::Channel channel)> traced;
};

}  // namespace cobot_command::command
