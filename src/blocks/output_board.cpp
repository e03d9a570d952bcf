#include "output_board.h"

#include <algorithm>

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

OutputBoard::OutputBoard(std::vector<Action>& actions) : actions_(actions) {
  for (std::size_t i = 0; i < kBlockCount; ++i) outputs_.push_back(idle(static_cast<Block>(i)));
  owners_.resize(kBlockCount);
}

BlockOutputs& OutputBoard::of(Block block) {
  return outputs_[static_cast<std::size_t>(block)];
}

GoalId& OutputBoard::ownerOf(Block block) {
  return owners_[static_cast<std::size_t>(block)];
}

void OutputBoard::open(Block block, GoalId goal) {
  const std::pair entry(block, goal);
  if (std::find(open_.begin(), open_.end(), entry) == open_.end()) open_.push_back(entry);
  of(block) = idle(block);
  of(block).busy = true;
  ownerOf(block) = goal;
}

void OutputBoard::reject(Block block, GoalId goal, Outcome outcome) {
  if (!of(block).busy) of(block) = ended(block, outcome);
  actions_.push_back(GoalEnded{goal, std::move(outcome)});
}

void OutputBoard::answer(Block block, GoalId goal, Outcome outcome) {
  actions_.push_back(GoalAccepted{goal});
  reject(block, goal, std::move(outcome));
}

void OutputBoard::wait(Block block, GoalId goal) {
  if (of(block).busy) {
    open_.emplace_back(block, goal);  // the outputs stay those of the goal in front
  } else {
    open(block, goal);
  }
}

void OutputBoard::accept(Block block, GoalId goal, int command_id_ack) {
  open(block, goal);
  of(block).command_id_ack = command_id_ack;
  actions_.push_back(GoalAccepted{goal});
}

void OutputBoard::progress(Block block, GoalId goal, Progress progress) {
  // A goal that waits says nothing of what the block does meanwhile. What is held may not have begun.
  if (progress.place_in_queue == 0 && progress.phase != Phase::Held) {
    of(block).active = progress.phase == Phase::Active || progress.phase == Phase::Dwelling ||
                       progress.phase == Phase::Connected;
  }
  actions_.push_back(GoalProgressed{goal, std::move(progress)});
}

void OutputBoard::end(Block block, GoalId goal, Outcome outcome) {
  open_.erase(std::remove(open_.begin(), open_.end(), std::pair(block, goal)), open_.end());
  const bool others =
      std::any_of(open_.begin(), open_.end(), [&](const auto& entry) { return entry.first == block; });
  if (others) {
    if (ownerOf(block) == goal) of(block).active = false;
  } else {
    of(block) = ended(block, outcome);
  }
  actions_.push_back(GoalEnded{goal, std::move(outcome)});
}

}  // namespace cobot_command::blocks
