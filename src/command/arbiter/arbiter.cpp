#include "arbiter/arbiter.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

using Failures = std::vector<blocks::Failure>;

void append(Failures& failures, const Failures& more) {
  failures.insert(failures.end(), more.begin(), more.end());
}

}  // namespace

Arbiter::Arbiter(const CoreParts& parts, CorePorts ports, Planning planning)
    : parts_(parts),
      desk_(parts.settings.planning_budget, parts.actions, planning),
      queue_(parts.board, desk_, parts.actions, std::move(ports.newest)),
      stop_(parts.settings, parts.script, parts.tags, parts.robot, parts.forecast.arm()),
      window_({parts.settings, parts.script, parts.tags, parts.robot, stop_, parts.forecast.arm()},
              parts.forecast, std::move(ports.gate)),
      stops_(parts, stop_, window_),
      plans_(parts, desk_, queue_,
             [this](Arrival arrival, Instant now) { return turns_.originBehind(arrival, now); }),
      turns_(parts, {desk_, queue_, plans_, stops_, window_}, std::move(ports.frames)) {}

// --- Goals: checked, then refused or taken.

void Arbiter::take(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  queue_.came(id);
  if (const auto why = queue_.fell(id, goal)) {
    parts_.board.abortAsItComes(blockOf(goal), id, *why);
    return;
  }
  const blocks::GoalTraits traits = blocks::GoalRules(goal).traits();
  switch (traits.way) {
    case blocks::Way::Link:
      connect(id, goal, now);
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
        queueUp(id, goal, traits.buffer_mode, now);
      }
      return;
  }
}

bool Arbiter::rejected(blocks::GoalId id, const blocks::Goal& goal, const Failures& failures) {
  if (failures.empty()) return false;
  const blocks::Block block = blockOf(goal);
  parts_.board.reject(block, id, toRejection(block, failures));
  return true;
}

void Arbiter::connect(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const auto& target = std::get<blocks::ConnectGoal>(goal);
  const bool may_move = parts_.forecast.loose().mayMove() || stops_.busy();
  if (rejected(id, goal, parts_.keeper.objectionsTo(target, turns_.busyWith(), may_move))) return;
  parts_.keeper.execute(id, target, now);
}

void Arbiter::stopOnRequest(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  constexpr const char* kWhy = "stopped by the stop block";
  queue_.dropAll(kWhy, id);  // also when there is nobody who could be told to stop
  if (rejected(id, goal, parts_.keeper.objectionsToATry())) return;
  stops_.accept(id);
  stopAll(kWhy, id, now);
  stops_.answerWithTheLast(id);
}

void Arbiter::sendBeside(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const blocks::GoalRules rules(goal);
  const bool tried_anyway = rules.traits().tried_anyway;
  const bool only_connection = tried_anyway && !parts_.keeper.run().disconnecting();
  Failures failures = rules.violations();
  append(failures, only_connection ? parts_.keeper.objectionsToATry() : parts_.keeper.objectionsToCommands());
  if (!tried_anyway && parts_.robot.emergencyStop()) {
    failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
  }
  blocks::sortByTable(failures);
  if (rejected(id, goal, failures)) return;
  const blocks::Command command = *rules.command();
  parts_.board.accept(command.block, id, command.traits.command_id);
  window_.sendBeside(command, id, now);
}

void Arbiter::answerByPlan(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  Failures failures = blocks::GoalRules(goal).violations();
  if (desk_.checks() >= kMostWaiting) failures.push_back(blocks::tooManyWait(desk_.checks()));
  blocks::sortByTable(failures);
  if (rejected(id, goal, failures)) return;
  plans_.check(id, goal, now);
}

void Arbiter::queueUp(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now) {
  Failures failures = blocks::GoalRules(goal).violations();
  append(failures, turns_.objectionsToAny(mode));
  blocks::sortByTable(failures);
  if (!rejected(id, goal, failures)) enqueue(id, goal, mode, now);
}

void Arbiter::enqueue(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode, Instant now) {
  const bool takes_over = mode == blocks::BufferMode::Aborting;
  if (takes_over) {
    abortAll(fmt::format("taken over by {}", toString(blockOf(goal))), id, now);
    if (stops_.mayMoveOtherwise() && !stops_.busy()) stops_.ask(now);
  }
  const bool is_behind_others = turns_.busyWith().has_value();
  Waiting waiting;
  waiting.id = id;
  waiting.goal = goal;
  waiting.takes_over = takes_over && stops_.busy();
  queue_.push(std::move(waiting));
  if (is_behind_others) plans_.foresee(now);
}

// --- Ends that are asked for.

void Arbiter::cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest) {
  const blocks::Run* const run = turns_.run();
  ConnectRun& connect = parts_.keeper.run();
  if (queue_.drop(id, "cancelled before its turn") || plans_.cancel(id)) return;
  if (run != nullptr && run->goal() == id) {
    queue_.dropAll(fmt::format("the command in front of it, {}, was cancelled", toString(run->block())),
                   newest.value_or(queue_.newest()));
    turns_.cancel("cancelled", now);
  } else if (connect.busy() && connect.goal() == id) {
    parts_.keeper.cancel(now);
    abortAll("the connection is being closed", newest.value_or(queue_.newest()), now);
    stops_.askIfMoving(now);
  }
}

FinishReport Arbiter::finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest) {
  FinishReport found;
  found.dropped = static_cast<int>(queue_.size());
  found.moves_on = parts_.forecast.loose().mayMove();
  queue_.dropAll(kNothingBehindFinish, newest.value_or(queue_.newest()));
  found.under_way = turns_.busyWith();
  turns_.finish(after, now);
  return found;
}

void Arbiter::retire(const std::string& why, Instant now) {
  abortAll(why, queue_.newest(), now);
  plans_.endAll(why);
  stops_.askIfMoving(now);
}

void Arbiter::shutDown(const std::string& why, Instant now) {
  queue_.dropAll(why);
  plans_.endAll(why);
  turns_.abandon(why, now);
  stops_.askIfMoving(now);
  window_.abandonBeside(why, now);
  settleBeside(now);
  turns_.settle(now);
  stops_.abortGoals(why);
}

void Arbiter::abortAll(const std::string& why, blocks::GoalId newest, Instant now) {
  queue_.dropAll(why, newest);
  turns_.cancel(why, now);
}

void Arbiter::stopAll(const std::string& why, blocks::GoalId newest, Instant now) {
  if (!window_.stopsWithACancel()) stops_.ask(now);
  abortAll(why, newest, now);
}

// --- Events.

void Arbiter::linkLost(const std::string& reason, Instant now) {
  queue_.dropAll("the link was lost: " + reason);
  window_.besideLinkLost(reason, now);
  turns_.linkLost(reason, now);
  stop_.linkLost(reason);
}

void Arbiter::disconnected(const std::string& reason, Instant now) {
  stop_.linkLost(reason);
  window_.besideLinkLost(reason, now);
  settle(now);
}

void Arbiter::answered(const link::ScriptAnswered& event, Instant now) {
  stop_.answered(event, now);
  window_.answered(event, now);
}

void Arbiter::robotChanged(Instant now) {
  turns_.robotChanged(now);
  stop_.robotChanged();
}

void Arbiter::advance(Instant now) {
  turns_.advance(now);
  stop_.advance(now);
  desk_.endOverdue(now);
}

std::optional<Instant> Arbiter::nextDeadline() const {
  return earlier(turns_.nextDeadline(), earlier(stop_.nextDeadline(), desk_.nextDeadline()));
}

// --- What follows.

void Arbiter::settle(Instant now) {
  settleStops(now);
  settleBeside(now);
  turns_.settle(now);
}

void Arbiter::settleStops(Instant now) {
  while (const auto result = stops_.takeResult(now)) {
    window_.stopEnded(*result, now);
    if (!result->failed()) continue;
    queue_.dropUnstopped(fmt::format("{}: {}", robot::LooseMotion::kMayStillMove, result->failure.found));
  }
}

void Arbiter::settleBeside(Instant now) {
  const char* unanswered = nullptr;
  for (const CommandWindow::Ended& ended : window_.takeEndedBeside()) {
    const bool got_no_reply = ended.outcome.error_id == blocks::motion_error::kReceiveReply;
    if (got_no_reply && ended.stops_unanswered) unanswered = toString(ended.block);
    parts_.board.end(ended.block, ended.goal, ended.outcome);
  }
  if (unanswered != nullptr) {
    stopAll(fmt::format("stopped, as {} got no reply", unanswered), queue_.newest(), now);
  }
}

void Arbiter::proceed(Instant now) {
  if (window_.empty() && !parts_.forecast.loose().mayMove() && !stops_.busy()) parts_.forecast.queueDone();
  desk_.proceed(now);
  turns_.tellPlaces();
}

// --- What is there.

bool Arbiter::idle() const {
  return turns_.run() == nullptr && window_.nothingBeside() && !stops_.busy();
}

bool Arbiter::mayMove() const {
  return parts_.forecast.loose().mayMove() || window_.mayMove();
}

bool Arbiter::mayBeMovedByUs() const {
  return !window_.empty() || parts_.forecast.loose().mayMove() || stops_.busy() || stops_.orphan().mayMove();
}

}  // namespace cobot_command::command
