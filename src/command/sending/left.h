// What is still to be sent of commands that were taken from the controller.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>

#include "queue/goal_queue.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::command {

/// A command, or the rest of one.
struct Left {
  blocks::Command command;
  blocks::Command at_segment_end;               ///< the same, from where its first motion ends
  blocks::GoalId goal = 0;                      ///< 0: nobody is told of it any more
  std::optional<arm::JointVector> segment_end;  ///< of its first motion [rad]; none: it does not move the arm
};

/// What was under way and waited, as it goes on behind an interruption.
struct Aside {
  std::unique_ptr<blocks::Run> run;  ///< nullptr: no goal was under way
  std::map<blocks::GoalId, tables::Hold> holds;
  std::deque<Left> left;
  std::deque<Waiting> waiting;
};

}  // namespace cobot_command::command
