#include "output_board.h"

namespace cobot_command::blocks {
namespace {

BlockOutputs idle(Block block) {
  BlockOutputs outputs;
  outputs.block = block;
  return outputs;
}

BlockOutputs ended(Block block, const Outcome& outcome) {
  BlockOutputs outputs = idle(block);
  outputs.done = outcome.ending == Ending::Done;
  outputs.error = outcome.ending == Ending::Rejected || outcome.ending == Ending::Aborted;
  outputs.command_aborted = outcome.ending == Ending::CommandAborted;
  outputs.error_id = outcome.error_id;
  outputs.error_description = outputs.error ? outcome.error_description : "";
  outputs.command_id_ack = outcome.command_id_ack;
  return outputs;
}

}  // namespace

OutputBoard::OutputBoard(std::vector<Action>& actions)
    : actions_(actions), outputs_{idle(Block::Connect), idle(Block::MoveAbsolute)} {}

BlockOutputs& OutputBoard::of(Block block) {
  return outputs_[static_cast<std::size_t>(block)];
}

void OutputBoard::reject(Block block, GoalId goal, Outcome outcome) {
  if (!of(block).busy) of(block) = ended(block, outcome);
  actions_.push_back(GoalEnded{goal, std::move(outcome)});
}

void OutputBoard::accept(Block block, GoalId goal, int command_id_ack) {
  of(block) = idle(block);
  of(block).busy = true;
  of(block).command_id_ack = command_id_ack;
  actions_.push_back(GoalAccepted{goal});
}

void OutputBoard::progress(Block block, GoalId goal, Progress progress) {
  of(block).active = progress.phase == Phase::Active || progress.phase == Phase::Connected;
  actions_.push_back(GoalProgressed{goal, std::move(progress)});
}

void OutputBoard::end(Block block, GoalId goal, Outcome outcome) {
  of(block) = ended(block, outcome);
  actions_.push_back(GoalEnded{goal, std::move(outcome)});
}

}  // namespace cobot_command::blocks
