#include "arbiter/arbiter.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

std::string cancelledInFront(blocks::Block block) {
  return fmt::format("the command before it, {}, was cancelled", toString(block));
}

}  // namespace

Arbiter::Arbiter(const CoreParts& parts, CorePorts ports, Planning planning)
    : parts_(parts),
      desk_(parts.settings.planning_budget, parts.actions, planning),
      queue_(parts.board, desk_, parts.actions, std::move(ports.newest)),
      stop_(parts.settings, parts.script, parts.tags, parts.robot, parts.forecast.arm()),
      window_({parts.settings, parts.script, parts.tags, parts.robot, stop_, parts.forecast.arm()},
              parts.forecast, desk_, std::move(ports.gate)),
      stops_(parts, stop_, window_),
      plans_(
          parts, desk_, queue_,
          [this](Ticket ticket, Instant now) { return turns_.occupancy().originBehind(ticket, now); },
          std::move(ports.program)),
      paths_(parts.paths, desk_, parts.actions),
      aside_(parts.board, parts.actions),
      turns_(parts, {desk_, queue_, plans_, stops_, window_, paths_, aside_}, std::move(ports.frames)),
      pause_({parts.paths, window_, parts.robot, parts.actions,
              [&keeper = parts.keeper] { return keeper.objectionsToATry(); },
              [&guard = parts.guard] { guard.resumed(); }}),
      feedrate_({parts.paths, paths_, pause_, window_, parts.forecast, parts.robot}),
      speed_({parts.speed, pause_, paths_, window_, parts.robot,
              [this] { return mayBeMovedByUs() || parts_.robot.moving().value_or(false); },
              [this] { queue_.forgetWholePlan(); }}),
      interruption_(parts, {desk_, queue_, plans_, stops_, window_, paths_, aside_}, turns_, pause_),
      interrupts_(parts, {desk_, queue_, plans_, stops_, window_, paths_, aside_}, turns_),
      front_desk_(parts, {desk_, queue_, plans_, stops_, window_, paths_, aside_}, turns_, pause_) {}

// --- Ends that are asked for.

void Arbiter::cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest) {
  if (parts_.exchange.serves(id)) {
    parts_.exchange.cancel(now);
    return;
  }
  if (aside_.cancel(id, "cancelled while it was suspended", now)) {
    if (!aside_.isThere() && queue_.empty()) {  // those that have not come to the core yet fall, too
      queue_.dropAll("the command before it was cancelled", newest.value_or(queue_.newest()));
    }
    return;
  }
  const blocks::Run* const run = turns_.run();
  ConnectRun& connect = parts_.keeper.run();
  const bool has_the_turn = run == nullptr && queue_.plansTheNext() && queue_.front().id == id;
  if (has_the_turn) {
    cancelTurn(newest.value_or(queue_.newest()), now);
    return;
  }
  if (queue_.drop(id, "cancelled before its turn") || plans_.cancel(id)) return;
  if (run != nullptr && run->serves(id)) {
    if (turns_.takeOut(id, "cancelled", now)) {
      queue_.dropFirst(run->block(), cancelledInFront(run->block()));
      return;
    }
    queue_.dropAll(cancelledInFront(run->block()), newest.value_or(queue_.newest()));
    turns_.cancel("cancelled", now);
  } else if (connect.busy() && connect.goal() == id) {
    parts_.keeper.cancel(now);
    turns_.abortAll("the connection is being closed", newest.value_or(queue_.newest()), now);
    stops_.askIfMoving(now);
  }
}

/// Of the goal that is planned, as its turn has come: nothing of it was sent, but a motion in front of it,
/// that nobody answers for any more, may be under way.
void Arbiter::cancelTurn(blocks::GoalId newest, Instant now) {
  const blocks::GoalId id = queue_.front().id;
  const blocks::Block block = blockOf(queue_.front().goal);
  static_cast<void>(queue_.drop(id, "cancelled while it was planned"));
  queue_.dropAll(cancelledInFront(block), newest);
  stops_.askIfMoving(now);
}

FinishReport Arbiter::finish(blocks::FinishAfter after, Instant now, std::optional<blocks::GoalId> newest) {
  FinishReport found;
  found.moves_on = parts_.forecast.loose().mayMove();
  found.dropped = queue_.dropBehindTurn(kNothingBehindFinish, newest.value_or(queue_.newest()));
  const auto kept = aside_.underWay() != 0 ? aside_.block() : std::nullopt;  // a wait ends at once
  found.dropped += aside_.finish(after, kNothingBehindFinish, now);
  found.under_way = turns_.occupancy().busyWith();
  if (!found.under_way) found.under_way = kept;
  turns_.finish(after, now);
  return found;
}

void Arbiter::retire(const std::string& why, Instant now) {
  turns_.abortAll(why, queue_.newest(), now);
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

// --- Events.

/// A command that is planned, as its turn has come, would be at the controller by now: it fails like one that
/// is.
void Arbiter::linkLost(const std::string& reason, Instant now) {
  if (!queue_.empty() && queue_.front().turn == Waiting::Turn::PlansCommand) {
    const blocks::Block block = blockOf(queue_.front().goal);
    queue_.refuse(queue_.front().id, toRejection(block, {{blocks::motion_error::kLinkDropped, reason, ""}}));
  }
  queue_.dropAll("the link was lost: " + reason);
  window_.besideLinkLost(reason, now);
  turns_.linkLost(reason, now);
  stop_.linkLost(reason);
  pause_.linkLost();
  parts_.guard.linkLost();
}

void Arbiter::disconnected(const std::string& reason, Instant now) {
  aside_.linkLost(reason, now);
  pause_.linkLost();
  parts_.guard.linkLost();
  stop_.linkLost(reason);
  window_.besideLinkLost(reason, now);
  parts_.paths.disconnected();
  parts_.jog.disconnected();
  settle(now);
}

void Arbiter::answered(const link::ScriptAnswered& event, Instant now) {
  stop_.answered(event, now);
  window_.answered(event, now);
}

void Arbiter::robotChanged(Instant now) {
  turns_.robotChanged(now);
  stop_.robotChanged();
  pause_.robotChanged();
}

void Arbiter::advance(Instant now) {
  parts_.hold.advance(now);
  turns_.advance(now);
  stop_.advance(now);
  desk_.endOverdue(now);
}

std::optional<Instant> Arbiter::nextDeadline() const {
  const auto held = earlier(parts_.hold.nextDeadline(), desk_.nextDeadline());
  const auto due = earlier(held, parts_.guard.nextDeadline());
  return earlier(turns_.nextDeadline(), earlier(stop_.nextDeadline(), due));
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
    turns_.stopEnded(*result, now);
    if (!result->failed()) {
      interruption_.stopConfirmed();
      continue;
    }
    queue_.dropUnstopped(fmt::format("{}: {}", robot::LooseMotion::kMayStillMove, result->failure.found));
  }
}

void Arbiter::settleBeside(Instant now) {
  const char* unanswered = nullptr;
  for (const CommandWindow::Ended& ended : window_.takeEndedBeside()) {
    const bool got_no_reply =
        isError(ended.block, ended.outcome.error_id, blocks::motion_error::kReceiveReply);
    if (got_no_reply && ended.stops_unanswered) unanswered = toString(ended.block);
    pause_.ended(ended);
    if (ended.goal != 0) parts_.board.end(ended.block, ended.goal, ended.outcome);
  }
  if (unanswered != nullptr) {
    turns_.stopAll(fmt::format("stopped, because {} got no reply", unanswered), queue_.newest(), now);
  }
}

void Arbiter::proceed(Instant now) {
  if (window_.empty() && !parts_.forecast.loose().mayMove() && !stops_.busy()) {
    parts_.forecast.queueDone();
    turns_.queueDone();
  }
  desk_.proceed(now);
  interruption_.proceed();
  interrupts_.look(now);  // also when nothing is begun any more: who asked is to be answered
  turns_.tellPlaces();
}

// --- What is there.

bool Arbiter::idle() const {
  return turns_.run() == nullptr && window_.nothingBeside() && !stops_.busy();
}

bool Arbiter::underWay() const {
  return turns_.isAnythingThere() || !queue_.empty() || aside_.isThere() || mayBeMovedByUs();
}

bool Arbiter::mayMove() const {
  return parts_.forecast.loose().mayMove() || window_.mayMove();
}

bool Arbiter::mayBeMovedByUs() const {
  return !window_.empty() || parts_.forecast.loose().mayMove() || stops_.busy() || stops_.orphan().mayMove();
}

}  // namespace cobot_command::command
