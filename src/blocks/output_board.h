// The PLCopen outputs of all blocks, and the actions that tell of them: the one place that ends goals.
#pragma once

#include <vector>

#include "cobot_command/blocks/command_core.h"

namespace cobot_command::blocks {

class OutputBoard {
 public:
  explicit OutputBoard(std::vector<Action>& actions);

  /// Without being accepted. The outputs stay those of the running goal, if the block has one.
  void reject(Block block, GoalId goal, Outcome outcome);
  void accept(Block block, GoalId goal, int command_id_ack);
  void progress(Block block, GoalId goal, Progress progress);
  void end(Block block, GoalId goal, Outcome outcome);

  [[nodiscard]] const std::vector<BlockOutputs>& outputs() const { return outputs_; }

 private:
  [[nodiscard]] BlockOutputs& of(Block block);

  std::vector<Action>& actions_;
  std::vector<BlockOutputs> outputs_;
};

}  // namespace cobot_command::blocks
