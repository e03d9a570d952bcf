// The goals of the stop block that wait for their stop.
#pragma once

#include <string>
#include <vector>

#include "board/output_board.h"
#include "stops/stop_run.h"

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::command {

class StopGoals {
 public:
  static constexpr blocks::Block kBlock = blocks::kBlock<blocks::StopGoal>;

  explicit StopGoals(OutputBoard& board) : board_(board) {}

  void accept(blocks::GoalId goal);
  /// It was accepted, and is answered by that stop.
  void wait(blocks::GoalId goal, StopRun::Number stop);
  [[nodiscard]] bool empty() const { return goals_.empty(); }
  /// Somebody asked for that stop by a goal, and answers for the robot with it.
  [[nodiscard]] bool asked(const StopRun::Result& result) const;
  void ended(const StopRun::Result& result);
  void abort(const std::string& why);

 private:
  struct Goal {
    blocks::GoalId id = 0;
    StopRun::Number stop = 0;
  };
  [[nodiscard]] std::vector<Goal>::const_iterator find(const StopRun::Result& result) const;

  OutputBoard& board_;
  std::vector<Goal> goals_;
};

}  // namespace cobot_command::command
