// The PLCopen outputs of all blocks, and the actions that tell of them: the one place that ends goals.
#pragma once

#include <utility>
#include <vector>

#include "cobot_command/blocks/command_core.h"

namespace cobot_command::blocks {

class OutputBoard {
 public:
  explicit OutputBoard(std::vector<Action>& actions);

  /// At once, without having waited. The outputs stay those of the block's open goals, if it has any.
  void reject(Block block, GoalId goal, Outcome outcome);
  /// At once, without anything executed: a check. The outputs stay likewise.
  void answer(Block block, GoalId goal, Outcome outcome);
  /// The goal waits for its turn: Busy, and not accepted yet.
  void wait(Block block, GoalId goal);
  void accept(Block block, GoalId goal, int command_id_ack);
  void progress(Block block, GoalId goal, Progress progress);
  /// Of a goal that waited or was accepted. With another goal of the same block still open, the block stays
  /// Busy.
  void end(Block block, GoalId goal, Outcome outcome);

  [[nodiscard]] const std::vector<BlockOutputs>& outputs() const { return outputs_; }

 private:
  [[nodiscard]] BlockOutputs& of(Block block);
  [[nodiscard]] GoalId& ownerOf(Block block);
  void open(Block block, GoalId goal);

  std::vector<Action>& actions_;
  std::vector<BlockOutputs> outputs_;
  std::vector<GoalId> owners_;                  ///< of the outputs of each block: what it executes
  std::vector<std::pair<Block, GoalId>> open_;  ///< goals that wait or run
};

}  // namespace cobot_command::blocks
