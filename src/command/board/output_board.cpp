#include "board/output_board.h"

#include <algorithm>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::command {
namespace {

BlockOutputs idle(blocks::Block block) {
  BlockOutputs outputs;
  outputs.block = block;
  return outputs;
}

BlockOutputs ended(blocks::Block block, const blocks::Outcome& outcome) {
  BlockOutputs outputs = idle(block);
  outputs.done = outcome.ending == blocks::Ending::Done;
  outputs.error = outcome.ending == blocks::Ending::Rejected || outcome.ending == blocks::Ending::Aborted;
  outputs.command_aborted = outcome.ending == blocks::Ending::CommandAborted;
  outputs.error_id = outcome.error_id;
  outputs.error_description = outputs.error ? outcome.error_description : "";
  outputs.command_id_ack = outcome.command_id_ack;
  return outputs;
}

/// Who reads the result of a goal is to know what else there is to know of it.
void tellRemarks(blocks::Outcome& outcome) {
  const bool is_done = outcome.ending == blocks::Ending::Done;
  const std::string text = is_done ? outcome.remarks.text() : outcome.remarks.textOfWarnings();
  if (text.empty()) return;
  outcome.error_description += outcome.error_description.empty() ? text : "; " + text;
}

}  // namespace

OutputBoard::OutputBoard(std::vector<Action>& actions) : actions_(actions) {
  for (std::size_t i = 0; i < blocks::kBlockCount; ++i) {
    outputs_.push_back(idle(static_cast<blocks::Block>(i)));
  }
  owners_.resize(blocks::kBlockCount);
  accepted_.resize(blocks::kBlockCount);
}

BlockOutputs& OutputBoard::of(blocks::Block block) {
  return outputs_[static_cast<std::size_t>(block)];
}

blocks::GoalId& OutputBoard::ownerOf(blocks::Block block) {
  return owners_[static_cast<std::size_t>(block)];
}

void OutputBoard::open(blocks::Block block, blocks::GoalId goal) {
  const std::pair entry(block, goal);
  if (std::find(open_.begin(), open_.end(), entry) == open_.end()) open_.push_back(entry);
  of(block) = idle(block);
  of(block).busy = true;
  ownerOf(block) = goal;
}

void OutputBoard::reject(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome) {
  if (!of(block).busy) of(block) = ended(block, outcome);
  actions_.push_back(GoalEnded{block, goal, std::move(outcome)});
}

void OutputBoard::abortAsItComes(blocks::Block block, blocks::GoalId goal, const std::string& why) {
  wait(block, goal);
  end(block, goal, blocks::commandAborted(why));
}

void OutputBoard::answer(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome) {
  actions_.push_back(GoalAccepted{block, goal});
  reject(block, goal, std::move(outcome));
}

void OutputBoard::wait(blocks::Block block, blocks::GoalId goal) {
  if (of(block).busy) {
    open_.emplace_back(block, goal);  // the outputs stay those of the goal in front
  } else {
    open(block, goal);
  }
}

int OutputBoard::accepted(blocks::Block block) const {
  return accepted_[static_cast<std::size_t>(block)];
}

void OutputBoard::accept(blocks::Block block, blocks::GoalId goal, int command_id_ack) {
  ++accepted_[static_cast<std::size_t>(block)];
  open(block, goal);
  of(block).command_id_ack = command_id_ack;
  actions_.push_back(GoalAccepted{block, goal});
}

void OutputBoard::progress(blocks::Block block, blocks::GoalId goal, blocks::Progress progress) {
  // A goal that waits says nothing of what the block does meanwhile. What is held may not have begun.
  if (progress.place_in_queue == 0 && progress.phase != blocks::Phase::Held) {
    of(block).active = progress.phase == blocks::Phase::Active || progress.phase == blocks::Phase::Dwelling ||
                       progress.phase == blocks::Phase::Connected;
  }
  progress.text = forPeople(std::move(progress.text));
  actions_.push_back(GoalProgressed{block, goal, std::move(progress)});
}

void OutputBoard::end(blocks::Block block, blocks::GoalId goal, blocks::Outcome outcome) {
  tellRemarks(outcome);
  open_.erase(std::remove(open_.begin(), open_.end(), std::pair(block, goal)), open_.end());
  const bool others =
      std::any_of(open_.begin(), open_.end(), [&](const auto& entry) { return entry.first == block; });
  if (others) {
    if (ownerOf(block) == goal) of(block).active = false;
  } else {
    of(block) = ended(block, outcome);
  }
  actions_.push_back(GoalEnded{block, goal, std::move(outcome)});
}

}  // namespace cobot_command::command
