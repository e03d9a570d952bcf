// The run of paths whose turn it is, as it is controlled from outside: told of that, and planned anew for it.
#pragma once

#include <vector>

#include "forecast/plan_desk.h"
#include "paths/path_desk.h"

#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::command {

class PathTurn {
 public:
  /// All have to live longer.
  PathTurn(PathDesk& desk, PlanDesk& planning, std::vector<Action>& actions)
      : desk_(desk), planning_(planning), actions_(actions) {}

  /// To be called behind every event, with whose turn it is.
  void serve(blocks::Run& run, Instant now);
  /// See PathControlled.
  void restart() {
    if (paths_ != nullptr) paths_->restart();
  }
  /// It is over, or set aside; it was on that controller.
  void leave(const blocks::ConnectGoal& controller);
  /// Of the run; what is with none, when it loads no paths.
  [[nodiscard]] blocks::PathPace pace() const {
    return paths_ != nullptr ? paths_->pace() : blocks::PathPace();
  }

 private:
  void planAnew(blocks::Block block, blocks::PathWork work, Instant now);

  PathDesk& desk_;
  PlanDesk& planning_;
  std::vector<Action>& actions_;
  const blocks::Run* run_ = nullptr;
  blocks::PathControlled* paths_ = nullptr;
};

}  // namespace cobot_command::command
