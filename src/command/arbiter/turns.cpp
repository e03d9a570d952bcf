#include "arbiter/turns.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

/// By the speed override, or the interface. What a run sets back behind itself, say, still goes out.
bool isHeld(const blocks::Command& command, const CoreParts& parts) {
  const bool is_held = parts.speed.isZero() || parts.permit.interrupts();
  return is_held && command.order(arm::Pose::Identity()).moves;
}

}  // namespace

Turns::Turns(const CoreParts& parts, const ArbiterDesks& desks, blocks::FrameFinder frames)
    : parts_(parts),
      desks_(desks),
      occupancy_(parts, desks.queue, desks.stops, desks.window, desks.aside, under_way_.run,
                 std::move(frames)),
      sender_({parts.settings, parts.forecast, desks.planning,
               [this](Instant now) { return occupancy_.originNow(now); }},
              parts.forecast, desks.window),
      admission_(parts, desks, occupancy_, sender_, under_way_) {}

// --- Begins.

void Turns::dispatch(Instant now) {
  while (!desks_.stops.busy() && !desks_.stops.holdsBack() && !stops_for_later_) {
    const bool went_on = sender_.goesOn() ? continueLeft(now)
                         : under_way_.run ? continueRun(now) || admission_.joinNext(now)
                                          : admission_.beginNext(now);
    if (!went_on) return;
    settle(now);
  }
}

/// Nothing (false) as long as the run has nothing to send, or that is planned.
bool Turns::continueRun(Instant now) {
  if (desks_.window.size() >= under_way_.run->window() || !desks_.window.goesOn()) return false;
  if (finishes_behind_motion_) {
    if (parts_.forecast.loose().mayMove() && parts_.robot.tellsMotion()) return false;
    finishes_behind_motion_ = false;
    under_way_.run->finish(blocks::FinishAfter::Move, now);
    return true;
  }
  const auto command = under_way_.run->next();
  if (!command) return false;
  if (command->leaves_only && !parts_.keeper.objectionsToCommands().empty()) {
    under_way_.run->commandEnded(command->key, {}, now);  // the flow has left the node by itself
    return true;
  }
  const auto ready = isHeld(*command, parts_) ? sender_.holdBack()
                                              : sender_.makeReady(*command, under_way_.run->goal(),
                                                                  occupancy_.objectionTo(*command), now);
  if (!ready.is_known) return false;
  if (ready.failure) {
    under_way_.run->commandRefused(command->key, *ready.failure, now);
  } else {
    under_way_.run->commandStarted(command->key);
    desks_.stops.commanded();
    const bool is_resumed = under_way_.run->goesOn() == blocks::Run::GoesOn::ByCommands;
    sender_.send(*command, under_way_.run->goal(), is_resumed, now);
  }
  return true;
}

bool Turns::continueLeft(Instant now) {
  if (!desks_.window.empty()) return false;
  const Left left = sender_.left();
  const auto ready =
      isHeld(left.command, parts_)
          ? sender_.holdBack()
          : sender_.makeReady(left.command, left.goal, occupancy_.objectionTo(left.command), now);
  if (!ready.is_known) return false;
  sender_.leftDone();
  if (ready.failure) {
    refuseLeft(left, *ready.failure, now);
  } else {
    desks_.stops.commanded();
    sender_.send(left.command, left.goal, true, now);
  }
  return true;
}

void Turns::refuseLeft(const Left& left, const blocks::Failure& failure, Instant now) {
  if (left.goal != 0) {
    under_way_.run->commandRefused(left.command.key, failure, now);
    return;
  }
  const std::string why =
      left.command.traits.awaits_motion
          ? fmt::format("the end of a blended motion could not be waited for: {}", failure.found)
          : fmt::format("the rest of a blended {} could not be continued: {}", toString(left.command.block),
                        failure.found);
  parts_.actions.emplace_back(LogMessage{Severity::Error, why});
  abortAll(why, desks_.queue.newest(), now);
}

void Turns::endLeft(const blocks::Outcome& outcome, Instant now) {
  for (const Left& left : sender_.dropLeft()) {
    if (left.goal != 0 && !kept_) kept_ = Untold{left.command.key, left.command.block};
  }
  const auto untold = std::exchange(kept_, std::nullopt);
  if (!untold || !under_way_.run || under_way_.run->outcome()) return;
  if (desks_.window.empty()) {
    under_way_.run->commandEnded(untold->key, outcome, now);
  } else {
    owed_ = untold;  // it ends with what is in front of it
  }
}

void Turns::endNobodys(const CommandWindow::Ended& ended, Instant now) {
  using blocks::Ending;
  if (const auto owed = std::exchange(owed_, std::nullopt); owed && under_way_.run) {
    const bool failed = ended.outcome.ending == Ending::Aborted;
    under_way_.run->commandEnded(
        owed->key,
        failed ? toOutcome(owed->block, Ending::Aborted, failureOf(ended.block, ended.outcome))
               : blocks::commandAborted(ended.outcome.error_description),
        now);
    if (ended.outcome.ending == Ending::Done) desks_.stops.askIfMoving(now);
    return;
  }
  if (ended.outcome.ending != Ending::Aborted) return;
  Left left;
  left.command.block = ended.block;
  left.command.traits.awaits_motion = ended.has_tag;
  refuseLeft(left, {ended.outcome.error_id, ended.outcome.error_description, ""}, now);
}

// --- Ends.

void Turns::settle(Instant now) {
  for (const auto& [key, progress] : desks_.window.takeProgress()) {
    if (CommandSender::isNobodys(key)) continue;
    under_way_.run->commandProgressed(key, progress, now);
  }
  for (const auto& [key, mark] : desks_.window.takePassed()) under_way_.run->commandPassed(key, mark, now);
  while (auto ended = desks_.window.takeEnded(now)) endCommand(std::move(*ended), now);
  if (under_way_.run) desks_.paths.serve(*under_way_.run, now);
  endRun(now);
}

void Turns::endCommand(CommandWindow::Ended ended, Instant now) {
  const bool is_stopped = ended.outcome.ending == blocks::Ending::CommandAborted;
  const bool is_kept = stops_for_later_ && is_stopped &&
                       (!under_way_.run || under_way_.run->goesOn() == blocks::Run::GoesOn::ByCommands);
  if (is_kept) {
    if (!CommandSender::isNobodys(ended.key)) kept_ = Untold{ended.key, ended.block};
    return;
  }
  sender_.ended(ended);
  if (CommandSender::isNobodys(ended.key)) {
    endNobodys(ended, now);
    return;
  }
  if (ended.leaves_node && under_way_.run->leavesNode() && parts_.keeper.objectionsToCommands().empty()) {
    desks_.stops.commanded();
    desks_.window.leaveNode(std::move(ended), now);
    return;
  }
  if (ended.outcome.ending == blocks::Ending::Aborted) parts_.robot.takeBackAcknowledgement();
  under_way_.run->reports().remark(ended.outcome.remarks);
  under_way_.run->commandEnded(ended.key, ended.outcome, now);
  under_way_.run->robotChanged(parts_.robot, now);
}

void Turns::endRun(Instant now) {
  if (!under_way_.run) return;
  tellReports(*under_way_.run, under_way_.holds, parts_.board, parts_.actions);
  if (!under_way_.run->outcome()) return;
  assert(desks_.window.empty());
  sender_.forget();
  desks_.paths.leave(parts_.keeper.run().target());
  parts_.jog.serve(under_way_.run->jog(), now);
  stopping_.reset();
  kept_.reset();
  owed_.reset();
  finishes_behind_motion_ = false;
  const auto done = std::exchange(under_way_.run, nullptr);
  desks_.queue.forgetTurn();  // what was to join it begins by itself
  under_way_.holds.clear();
  if (done->failed()) {
    stops_for_later_ = false;
    if (done->leavesMotions()) desks_.stops.askIfMoving(now);
    // Before the end of the goal itself: its error is what the block shows then.
    desks_.queue.dropAll(fmt::format("the command before it, {}, failed", toString(done->block())));
  }
  desks_.aside.ended(done->goal(), done->outcome()->ending == blocks::Ending::Done,
                     {parts_.forecast.frames(), parts_.forecast.load()});
  parts_.board.end(done->block(), done->goal(), *done->outcome());
}

void Turns::cancel(const std::string& why, Instant now) {
  stops_for_later_ = false;
  if (isBetweenCommands()) {
    static_cast<void>(sender_.dropLeft());
    kept_.reset();
    stopBetweenCommands(why, now);
    return;
  }
  if (under_way_.run) under_way_.run->cancel(why, now);
  endLeft(blocks::commandAborted(why), now);
  cancelWindow(why, now);
}

void Turns::interrupt(const std::string& why, Instant now) {
  if (!under_way_.run || isBetweenCommands()) {
    cancel(why, now);
    return;
  }
  stops_for_later_ = false;
  under_way_.run->interrupt(why, now);
  endLeft(blocks::commandAborted(why), now);
  cancelWindow(why, now);
}

void Turns::cancelWindow(const std::string& why, Instant now) {
  if (!under_way_.run || !desks_.window.empty()) parts_.forecast.forgetPath();  // else it stays as it is
  desks_.window.cancel(why, now);
}

bool Turns::isBetweenCommands() const {
  return under_way_.run && !under_way_.run->outcome() && !under_way_.run->leavesTheRobot() &&
         desks_.window.empty() && parts_.forecast.loose().mayMove();
}

/// To the goal it is as if its last command was still under way: it ends with what becomes of the robot.
void Turns::stopBetweenCommands(const std::string& why, Instant now) {
  if (stopping_) return;
  sender_.forget();
  if (!desks_.stops.busy()) desks_.stops.ask(now);
  if (!desks_.stops.busy()) {  // nobody hears it
    under_way_.run->cancel(why, now);
    return;
  }
  stopping_ = Stopping{desks_.stops.last(), why};
  blocks::Progress progress;
  progress.phase = blocks::Phase::Stopping;
  progress.text = why + ", stopping the robot";
  under_way_.run->commandProgressed(0, progress, now);
}

void Turns::stopEnded(const StopRun::Result& result, Instant now) {
  const bool was_for_later =
      result.failed() && std::exchange(stops_for_later_, false) && desks_.window.empty();
  const bool was_for_run = stopping_ && stopping_->stop == result.number;
  if ((!was_for_later && !was_for_run) || !under_way_.run || under_way_.run->outcome()) return;
  const auto next = under_way_.run->next();
  const blocks::Block block = next ? next->block : under_way_.run->block();
  under_way_.run->commandEnded(
      next ? next->key : 0,
      result.failed() ? toOutcome(block, blocks::Ending::Aborted, result.failure)
                      : blocks::commandAborted(fmt::format("{}; {}", stopping_->why, result.words())),
      now);
}

bool Turns::takeOut(blocks::GoalId goal, const std::string& why, Instant now) {
  return under_way_.run && under_way_.run->chain() != nullptr &&
         under_way_.run->chain()->takeOut(goal, why, now);
}

void Turns::abandon(const std::string& why, Instant now) {
  desks_.aside.drop(why, now);
  stops_for_later_ = false;
  if (under_way_.run) under_way_.run->cancel(why, now);
  endLeft(blocks::commandAborted(why), now);
  desks_.window.abandon(why, now);
  settle(now);
  if (!under_way_.run) return;
  // What it would set back behind itself is not sent any more.
  if (const auto last = under_way_.run->next()) {
    under_way_.run->commandRefused(last->key, {blocks::own_error::kShutDown, why, ""}, now);
  }
}

void Turns::finish(blocks::FinishAfter after, Instant now) {
  const bool behind_motion =
      after == blocks::FinishAfter::Move && isBetweenCommands() && parts_.robot.tellsMotion();
  if (behind_motion) {
    finishes_behind_motion_ = true;
  } else if (under_way_.run) {
    under_way_.run->finish(after, now);
  }
}

void Turns::abortAll(const std::string& why, blocks::GoalId newest, Instant now) {
  desks_.queue.dropAll(why, newest);
  desks_.aside.drop(why, now);
  interrupt(why, now);
}

void Turns::stopAll(const std::string& why, blocks::GoalId newest, Instant now) {
  if (!desks_.window.stopsWithACancel()) desks_.stops.ask(now);
  abortAll(why, newest, now);
}

// --- Events.

void Turns::linkLost(const std::string& reason, Instant now) {
  stops_for_later_ = false;
  desks_.aside.linkLost(reason, now);
  desks_.window.linkLost(reason, now);
  if (sender_.goesOn() || kept_) {
    const blocks::Block block = kept_ ? kept_->block : sender_.left().command.block;
    endLeft(toOutcome(block, blocks::Ending::Aborted, {blocks::motion_error::kLinkDropped, reason, ""}), now);
  }
  const auto patience =
      parts_.robot.status() ? std::optional(parts_.settings.evidence_timeout) : std::nullopt;
  if (under_way_.run) under_way_.run->linkLost(reason, patience, now);
}

void Turns::robotChanged(Instant now) {
  sender_.see(parts_.robot, now);
  desks_.window.robotChanged(now);
  if (!under_way_.run) return;
  under_way_.run->robotChanged(parts_.robot, now);
  if (const auto why = under_way_.run->stopsFor()) cancelWindow(*why, now);
}

void Turns::advance(Instant now) {
  desks_.window.advance(now);
  parts_.jog.serve(under_way_.run ? under_way_.run->jog() : nullptr, now);
  if (!under_way_.run) return;
  under_way_.run->advance(now);
  if (const auto why = under_way_.run->stopsFor()) cancelWindow(*why, now);
}

std::optional<Instant> Turns::nextDeadline() const {
  const auto next = desks_.window.nextDeadline();
  return under_way_.run ? earlier(next, under_way_.run->nextDeadline()) : next;
}

// --- Interruptions.

void Turns::stopForLater(const std::string& why, Instant now) {
  stops_for_later_ = true;
  sender_.forget();
  if (under_way_.run && under_way_.run->goesOn() == blocks::Run::GoesOn::ByItself) desks_.paths.restart();
  parts_.forecast.forgetPath();
  desks_.window.cancel(why, now);
  desks_.stops.askIfMoving(now);
}

bool Turns::hasStoppedForLater() const {
  const bool is_planned = !desks_.paths.pace().is_restarting;
  return stops_for_later_ && desks_.window.empty() && !desks_.stops.busy() &&
         !parts_.forecast.loose().mayMove() && parts_.robot.moving() == false && is_planned;
}

Aside Turns::takeAside(Instant now) {
  if (std::exchange(finishes_behind_motion_, false)) under_way_.run->finish(blocks::FinishAfter::Move, now);
  stops_for_later_ = false;
  kept_.reset();
  Aside aside;
  const bool by_itself = under_way_.run && under_way_.run->goesOn() == blocks::Run::GoesOn::ByItself;
  if (by_itself) sender_.queueDone();
  aside.left = sender_.takeLeft();
  for (Left& left : sender_.dropLeft()) aside.left.push_back(std::move(left));
  aside.run = std::exchange(under_way_.run, nullptr);
  aside.holds = std::exchange(under_way_.holds, {});
  aside.waiting = desks_.queue.takeAll();
  desks_.paths.leave(parts_.keeper.run().target());
  return aside;
}

void Turns::putBack(Aside aside, Instant now) {
  sender_.goOnWith(std::move(aside.left));
  under_way_ = {std::move(aside.run), std::move(aside.holds)};
  desks_.queue.putBackAll(std::move(aside.waiting));
  if (!under_way_.run) return;
  desks_.paths.serve(*under_way_.run, now);
  under_way_.run->robotChanged(parts_.robot, now);
}

// --- What the goals that wait are told.

void Turns::tellPlaces() {
  desks_.queue.tellPlaces([this](int place) { return occupancy_.textOfPlace(place); });
}

}  // namespace cobot_command::command
