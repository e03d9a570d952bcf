#include "arbiter/interruption.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

void Interruption::look(Instant now) {
  SyncGuard::Seen seen;
  seen.judged = parts_.sync.isJudged();
  seen.in_sync = parts_.sync.isInSync();
  seen.robot_enabled = parts_.keeper.isRobotEnabled(parts_.robot);
  seen.anything_there =
      turns_.isAnythingThere() || !desks_.queue.empty() || parts_.forecast.loose().mayMove();
  seen.moves = moves();
  parts_.guard.look(seen, now);
  if (parts_.guard.takePause()) pause_.pauseForGood(now);
  if (parts_.guard.takeTold()) warnOfReaction();
  const bool holds_back = parts_.guard.interrupts() || parts_.speed.isZero();
  if (std::exchange(held_back_, holds_back) != holds_back) desks_.queue.retell();
  if (parts_.exchange.takeDisabled() && parts_.exchange.isRequired()) stopWithout(now);
}

bool Interruption::moves() const {
  return turns_.isAnythingThere() || parts_.forecast.loose().mayMove() || desks_.window.mayMove();
}

void Interruption::stopWithout(Instant now) {
  constexpr const char* kWhy = "exchange_configuration, which motions require, was disabled";
  if (!moves() && desks_.queue.empty()) return;
  parts_.actions.emplace_back(
      LogMessage{Severity::Error, std::string(kWhy) + ": the robot is sent a stop command",
                 blocks::exchange_error::kMandatoryStopped, "enable it again before the next motion"});
  turns_.stopAll(kWhy, desks_.queue.newest(), now);
}

/// A stop that leaves a run behind it, of a goal that takes over, has emptied nothing.
void Interruption::proceed() {
  const bool is_empty = turns_.run() == nullptr && desks_.queue.empty();
  if (std::exchange(is_stopped_, false) && is_empty) parts_.guard.emptied();
  if (!desks_.queue.empty()) parts_.guard.motionWaits();
}

void Interruption::warnOfReaction() {
  using namespace blocks::interface_error;
  const bool refuses = parts_.guard.refuses();
  const int code = refuses ? kNotSynchronized : kInterrupted;
  const std::string remedy = parts_.permit.remedy();
  parts_.actions.emplace_back(LogMessage{
      Severity::Warning,
      fmt::format("motions are {}: {}", refuses ? "refused" : "interrupted", parts_.sync.whyNot()), code,
      remedy.empty() ? blocks::findError(blocks::kBlock<blocks::MoveAbsoluteGoal>, code)->remedy : remedy});
}

}  // namespace cobot_command::command
