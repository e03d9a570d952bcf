// The PLCopen outputs of all blocks, and the actions that tell of them: the one place that ends goals.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cobot_command/command/actions.h"

namespace cobot_command::command {

class OutputBoard {
 public:
  explicit OutputBoard(std::vector<Action>& actions);

  /// At once, without having waited. The outputs stay those of the block's open goals, if it has any.
  void reject(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome);
  /// At once, without anything executed: a check. The outputs stay likewise.
  void answer(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome);
  /// The goal waits for its turn: Busy, and not accepted yet.
  void wait(blocks::Block block, blocks::GoalId goal);
  /// Of a goal that may not even wait.
  void abortAsItComes(blocks::Block block, blocks::GoalId goal, const std::string& why);
  void accept(blocks::Block block, blocks::GoalId goal, int command_id_ack);
  void progress(blocks::Block block, blocks::GoalId goal, blocks::Progress progress);
  /// Of a goal that waited or was accepted. With another goal of the same block still open, the block stays
  /// Busy.
  void end(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome);

  [[nodiscard]] const std::vector<BlockOutputs>& outputs() const { return outputs_; }
  /// So many goals of that block were accepted until now.
  [[nodiscard]] int accepted(blocks::Block block) const;

 private:
  [[nodiscard]] BlockOutputs& of(blocks::Block block);
  [[nodiscard]] blocks::GoalId& ownerOf(blocks::Block block);
  void open(blocks::Block block, blocks::GoalId goal);

  std::vector<Action>& actions_;
  std::vector<BlockOutputs> outputs_;
  std::vector<blocks::GoalId> owners_;  ///< of the outputs of each block: what it executes
  std::vector<int> accepted_;           ///< goals of each block
  std::vector<std::pair<blocks::Block, blocks::GoalId>> open_;  ///< goals that wait or run
};

}  // namespace cobot_command::command
