#include "arbiter/interruption.h"

#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/blocks/goal_rules.h"

namespace cobot_command::command {
namespace {

/// SRCI's number.
constexpr int kMandatoryStopped = 0x8A02;
/// Of a Pause() for no goal; those of PauseDesk count up from 1.
constexpr blocks::CommandKey kPause = std::numeric_limits<blocks::CommandKey>::max();

blocks::Command pauseCommand() {
  blocks::Order order = blocks::settingOrder(script::Pause{});
  order.stops_unanswered = true;
  blocks::Command command;
  command.key = kPause;
  command.block = blocks::kBlock<blocks::ProgramControlGoal>;
  command.order = [order](const arm::Pose& /*base*/) { return order; };
  return command;
}

}  // namespace

void Interruption::look(Instant now) {
  SyncReaction::Seen seen;
  seen.judged = parts_.sync.isJudged();
  seen.in_sync = parts_.sync.isInSync();
  seen.robot_enabled =
      parts_.keeper.run().ready() && !parts_.robot.emergencyStop() && !parts_.robot.showsError();
  seen.anything_there = turns_.run() != nullptr || !desks_.queue.empty() || parts_.forecast.loose().mayMove();
  const bool interrupted_before = parts_.reaction.interrupts();
  parts_.reaction.look(seen, now);
  if (parts_.reaction.takePause()) pause(now);
  if (parts_.reaction.takeTold()) {
    warn(fmt::format("{}: {}", parts_.reaction.refuses() ? "motions are refused" : "motions are interrupted",
                     parts_.sync.whyNot()));
  }
  if (interrupted_before != parts_.reaction.interrupts()) desks_.queue.retell();
  if (parts_.exchange.takeDisabled() && parts_.exchange.isRequired()) stopWithout(now);
}

void Interruption::pause(Instant now) {
  desks_.window.sendBeside(pauseCommand(), 0, now);
  pause_.pausedByOthers();
}

void Interruption::stopWithout(Instant now) {
  constexpr const char* kWhy = "exchange_configuration was disabled, which motions need";
  const bool moves = turns_.run() != nullptr || parts_.forecast.loose().mayMove() || desks_.window.mayMove();
  if (!moves && desks_.queue.empty()) return;
  parts_.actions.emplace_back(LogMessage{Severity::Error, std::string(kWhy) + ": the robot is told to stop",
                                         kMandatoryStopped, "enable it again before the next motion"});
  turns_.stopAll(kWhy, desks_.queue.newest(), now);
}

void Interruption::ended(const CommandWindow::Ended& ended) {
  const bool is_done = ended.outcome.ending == blocks::Ending::Done;
  if (ended.goal != 0) {
    parts_.permit.ended(ended.goal, is_done);
  } else if (ended.key == kPause && !is_done) {
    warn("the controller has not taken the pause, the motion under way goes on: " +
         ended.outcome.error_description);
  }
}

void Interruption::proceed() {
  if (is_stopped_ && turns_.run() == nullptr && desks_.queue.empty()) {
    parts_.reaction.emptied();
    is_stopped_ = false;
  }
  if (!desks_.queue.empty()) parts_.reaction.motionWaits();
}

void Interruption::warn(std::string text) {
  parts_.actions.emplace_back(LogMessage{Severity::Warning, std::move(text)});
}

}  // namespace cobot_command::command
