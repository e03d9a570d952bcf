#include "sending/command_sender.h"

#include <utility>
#include <vector>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::command {

std::optional<blocks::Failure> CommandSender::prepare(const blocks::Command& command, Instant now) {
  if (next_.failure()) return next_.failure();
  return window_.prepare(next_.order(), command.traits, now);
}

CommandSender::Readiness CommandSender::makeReady(const blocks::Command& command, blocks::GoalId goal,
                                                  std::optional<blocks::Failure> objection, Instant now) {
  if (!objection) {
    if (look(command, goal, now) == NextCommand::State::Planning) return {};
    objection = prepare(command, now);
  }
  if (objection) forget();
  return {true, std::move(objection)};
}

CommandSender::Readiness CommandSender::holdBack() {
  forget();
  return {};
}

void CommandSender::send(const blocks::Command& command, blocks::GoalId goal, bool is_resumed, Instant now) {
  CommandOrder order = std::move(next_.order());
  next_.forget();
  order.goal = goal;
  if (is_resumed) trail_.sent(command, order, forecast_.frames());
  window_.send(std::move(order), now);
}

void CommandSender::see(const robot::RobotWatch& robot, Instant now) {
  if (trail_.empty() || !robot.joints()) return;
  trail_.see(*robot.joints(), robot.moving().value_or(true) && !robot.held(), now);
}

void CommandSender::ended(const CommandWindow::Ended& ended) {
  if (ended.outcome.ending == blocks::Ending::Done) {
    trail_.ended(ended.goal, ended.key, ended.has_tag);
  } else {
    trail_.clear();
  }
}

std::optional<std::string> CommandSender::objectionToResuming() const {
  if (trail_.empty()) return std::nullopt;
  if (forecast_.arm() == nullptr) return "the command layer has no model of the arm";
  return trail_.objection();
}

std::deque<Left> CommandSender::takeLeft() {
  std::deque<Left> left;
  if (!trail_.empty()) left = trail_.left(*forecast_.arm());
  trail_.clear();
  return left;
}

void CommandSender::askForRest() {
  Left rest;
  rest.command.key = nobodys_++;
  rest.command.block = blocks::kBlock<blocks::RunScriptGoal>;
  rest.command.traits.awaits_motion = true;
  // As long as its tag is awaited the arm moves: a cancel has to stop it.
  rest.command.order = [](const arm::Pose& /*base*/) {
    return blocks::motionOrder(std::vector<script::ScriptCommand>{});
  };
  left_.push_back(std::move(rest));
}

void CommandSender::goOnWith(std::deque<Left> left) {
  left_ = std::move(left);
  for (Left& one : left_) {
    if (one.goal == 0) one.command.key = nobodys_++;
  }
}

}  // namespace cobot_command::command
