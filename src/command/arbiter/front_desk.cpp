#include "arbiter/front_desk.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

using Failures = std::vector<blocks::Failure>;

constexpr const char* kStopped = "stopped by the stop block";

void append(Failures& failures, const Failures& more) {
  failures.insert(failures.end(), more.begin(), more.end());
}

}  // namespace

void FrontDesk::take(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  desks_.queue.came(id);
  blocks::GoalTraits traits = blocks::GoalRules(goal).traits();
  // A stop goes first: what was received before it may come behind it.
  const bool is_overtaken = id < last_stop_ && traits.way == blocks::Way::Beside;
  const auto why = is_overtaken ? std::make_optional<std::string>(kStopped) : desks_.queue.fell(id, goal);
  if (why) {
    parts_.board.abortAsItComes(blockOf(goal), id, *why);
    return;
  }
  traits.buffer_mode = turns_.occupancy().modeOf(blockOf(goal), traits);
  switch (traits.way) {
    case blocks::Way::Link:
      connect(id, goal, now);
      return;
    case blocks::Way::Configure:
      parts_.exchange.execute(id, std::get<blocks::ExchangeConfigurationGoal>(goal), now);
      return;
    case blocks::Way::Stop:
      stopOnRequest(id, goal, now);
      return;
    case blocks::Way::Beside:
      sendBeside(id, goal, now);
      return;
    case blocks::Way::Plan:
      answerByPlan(id, goal, now);
      return;
    case blocks::Way::Queue:
      if (traits.check_only) {
        answerByPlan(id, goal, now);
      } else {
        queueUp(id, goal, traits, now);
      }
      return;
  }
}

bool FrontDesk::rejected(blocks::GoalId id, const blocks::Goal& goal, const Failures& failures) {
  if (failures.empty()) return false;
  const blocks::Block block = blockOf(goal);
  parts_.board.reject(block, id, toRejection(block, failures));
  return true;
}

void FrontDesk::connect(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const auto& target = std::get<blocks::ConnectGoal>(goal);
  const bool may_move = parts_.forecast.loose().mayMove() || desks_.stops.busy();
  const auto busy = turns_.occupancy().busyWith();
  const auto block = busy ? busy : desks_.aside.block();
  if (rejected(id, goal, parts_.keeper.objectionsTo(target, block, may_move))) return;
  parts_.keeper.execute(id, target, now);
}

void FrontDesk::stopOnRequest(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  last_stop_ = std::max(last_stop_, id);
  desks_.queue.dropAll(kStopped, id);  // also when there is nobody who could be told to stop
  if (rejected(id, goal, parts_.keeper.objectionsToATry())) return;
  desks_.stops.accept(id);
  turns_.stopAll(kStopped, id, now);
  desks_.stops.answerWithTheLast(id);
}

void FrontDesk::sendBeside(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const blocks::GoalRules rules(goal);
  const blocks::GoalTraits traits = rules.traits();
  const bool tried_anyway = traits.tried_anyway;
  const bool only_connection = tried_anyway && !parts_.keeper.run().disconnecting();
  Failures failures = rules.violations();
  append(failures, only_connection ? parts_.keeper.objectionsToATry() : parts_.keeper.objectionsToCommands());
  append(failures, parts_.permit.objectionsTo(traits));
  if (traits.resumes && parts_.speed.isZero()) failures.push_back({blocks::own_error::kOverrideZero, "", ""});
  if (!tried_anyway && parts_.robot.emergencyStop()) {
    failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
  }
  sortByTable(blockOf(goal), failures);
  if (rejected(id, goal, failures)) return;
  const blocks::Command command = *rules.command();
  parts_.board.accept(command.block, id, command.traits.command_id);
  desks_.window.sendBeside(command, id, now);
  if (traits.halts || traits.resumes) pause_.sentFor(id, traits.halts);
}

void FrontDesk::answerByPlan(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  Failures failures = blocks::GoalRules(goal).violations();
  if (const auto waiting = desks_.planning.checks(); waiting >= kMostWaiting) {
    failures.push_back(blocks::tooManyWait(waiting));
  }
  sortByTable(blockOf(goal), failures);
  if (rejected(id, goal, failures)) return;
  desks_.plans.check(id, goal, turns_.occupancy().chainFor(blockOf(goal)), now);
}

void FrontDesk::queueUp(blocks::GoalId id, const blocks::Goal& goal, const blocks::GoalTraits& traits,
                        Instant now) {
  Failures failures = blocks::GoalRules(goal).violations();
  const Failures of_interface = parts_.permit.objectionsTo(traits);
  // That others are in front of it is for the same reason then.
  const blocks::BufferMode mode = of_interface.empty() ? traits.buffer_mode : blocks::BufferMode::Aborting;
  append(failures, turns_.occupancy().objectionsToAny(mode, traits.needs_automatic));
  append(failures, of_interface);
  if (failures.empty() && turns_.isStoppingForLater() && mode == blocks::BufferMode::Refuse) {
    failures.push_back(
        {blocks::motion_error::kOtherBlockBusy, "the running command is being interrupted", ""});
  }
  if (failures.empty() && traits.needs_standstill && !turns_.occupancy().robotStands()) {
    failures.push_back({blocks::motion_error::kOtherBlockBusy, "the robot moves", ""});
  }
  sortByTable(blockOf(goal), failures);
  if (!rejected(id, goal, failures)) enqueue(id, goal, traits.buffer_mode, now);
}

void FrontDesk::enqueue(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now) {
  const bool takes_over = mode == blocks::BufferMode::Aborting;
  if (takes_over) {
    turns_.abortAll(fmt::format("taken over by {}", toString(blockOf(goal))), id, now);
    if (desks_.stops.mayMoveOtherwise() && !desks_.stops.busy()) desks_.stops.ask(now);
  }
  // Its own wish: behind another one of its kind a path counts as one that waits.
  const bool waits = blocks::GoalRules(goal).traits().buffer_mode == blocks::BufferMode::Buffered;
  if (waits && desks_.aside.isThere()) {
    Waiting waiting;
    waiting.id = id;
    waiting.goal = goal;
    desks_.queue.push(std::move(waiting));
    desks_.aside.push(desks_.queue.takeLast());
    return;
  }
  const bool is_behind_others = turns_.occupancy().busyWith().has_value();
  const bool begins_a_hold =
      !is_behind_others && !takes_over && motionsOf(goal) > 0 && turns_.occupancy().robotStands();
  if (begins_a_hold) parts_.hold.begin(id, now);
  const auto* const way_back = std::get_if<blocks::ReturnToPrimaryGoal>(&goal);
  if (way_back != nullptr && way_back->allow_differences) desks_.aside.allowSetupBehind(id);
  Waiting waiting;
  waiting.id = id;
  waiting.goal = goal;
  waiting.takes_over = takes_over && desks_.stops.busy();
  desks_.queue.push(std::move(waiting));
  if (is_behind_others) desks_.plans.foresee(now);
}

}  // namespace cobot_command::command
