#include "arbiter/turns.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {

Turns::Turns(const CoreParts& parts, const ArbiterDesks& desks, blocks::FrameFinder frames)
    : parts_(parts),
      desks_(desks),
      occupancy_(parts, desks.queue, desks.stops, desks.window, under_way_.run, std::move(frames)),
      sender_({parts.settings, parts.forecast, desks.planning,
               [this](Instant now) { return occupancy_.originNow(now); }},
              parts.forecast, desks.window),
      admission_(parts, desks, occupancy_, sender_, under_way_) {}

// --- Begins.

void Turns::dispatch(Instant now) {
  while (!desks_.stops.busy() && !desks_.stops.holdsBack()) {
    const bool went_on =
        under_way_.run ? continueRun(now) || admission_.joinNext(now) : admission_.beginNext(now);
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
  // What it sets back behind itself, say, still goes out.
  const bool is_held = parts_.speed.isZero() || parts_.permit.interrupts();
  if (is_held && command->order(arm::Pose::Identity()).moves) {
    sender_.forget();  // its plan is made anew when it goes on, with all the time that a plan has
    return false;
  }
  if (command->leaves_only && !parts_.keeper.objectionsToCommands().empty()) {
    under_way_.run->commandEnded(command->key, {}, now);  // the flow has left the node by itself
    return true;
  }
  auto failure = occupancy_.objectionTo(*command);
  if (!failure) {
    if (sender_.look(*command, under_way_.run->goal(), now) == NextCommand::State::Planning) return false;
    failure = sender_.prepare(*command, now);
  }
  if (failure) {
    sender_.forget();
    under_way_.run->commandRefused(command->key, *failure, now);
  } else {
    under_way_.run->commandStarted(command->key);
    desks_.stops.commanded();
    sender_.send(*command, under_way_.run->goal(), now);
  }
  return true;
}

// --- Ends.

void Turns::settle(Instant now) {
  for (const auto& [key, progress] : desks_.window.takeProgress()) {
    under_way_.run->commandProgressed(key, progress, now);
  }
  for (const auto& [key, mark] : desks_.window.takePassed()) under_way_.run->commandPassed(key, mark, now);
  while (auto ended = desks_.window.takeEnded(now)) endCommand(std::move(*ended), now);
  if (under_way_.run) desks_.paths.serve(*under_way_.run, now);
  endRun(now);
}

void Turns::endCommand(CommandWindow::Ended ended, Instant now) {
  if (ended.leaves_node && under_way_.run->leavesNode() && parts_.keeper.objectionsToCommands().empty()) {
    desks_.stops.commanded();
    desks_.window.leaveNode(std::move(ended), now);
    return;
  }
  if (ended.outcome.ending == blocks::Ending::Aborted) parts_.robot.takeBackAcknowledgement();
  under_way_.run->commandEnded(ended.key, ended.outcome, now);
  under_way_.run->robotChanged(parts_.robot, now);
}

void Turns::tellRun() {
  blocks::RunReports& reports = under_way_.run->reports();
  for (auto& [goal, progress] : reports.takeProgress()) {
    parts_.board.progress(under_way_.run->block(), goal, std::move(progress));
  }
  for (auto& news : reports.takeNews())
    parts_.actions.emplace_back(RunTold{under_way_.run->block(), std::move(news)});
  for (auto& [goal, outcome] : reports.takeEnded()) {
    under_way_.holds.erase(goal);
    parts_.board.end(under_way_.run->block(), goal, std::move(outcome));
  }
}

void Turns::endRun(Instant now) {
  if (!under_way_.run) return;
  tellRun();
  if (!under_way_.run->outcome()) return;
  assert(desks_.window.empty());
  sender_.forget();
  desks_.paths.leave();
  parts_.jog.serve(under_way_.run->jog(), now);
  stopping_.reset();
  finishes_behind_motion_ = false;
  const auto done = std::exchange(under_way_.run, nullptr);
  desks_.queue.forgetTurn();  // what was to join it begins by itself
  under_way_.holds.clear();
  if (done->failed()) {
    if (done->leavesMotions()) desks_.stops.askIfMoving(now);
    // Before the end of the goal itself: its error is what the block shows then.
    desks_.queue.dropAll(fmt::format("the command in front of it, {}, failed", toString(done->block())));
  }
  parts_.board.end(done->block(), done->goal(), *done->outcome());
}

void Turns::cancel(const std::string& why, Instant now) {
  if (isBetweenCommands()) {
    stopBetweenCommands(why, now);
    return;
  }
  if (under_way_.run) under_way_.run->cancel(why, now);
  cancelWindow(why, now);
}

void Turns::interrupt(const std::string& why, Instant now) {
  if (!under_way_.run || isBetweenCommands()) {
    cancel(why, now);
    return;
  }
  under_way_.run->interrupt(why, now);
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
  if (!stopping_ || stopping_->stop != result.number || !under_way_.run || under_way_.run->outcome()) return;
  const auto next = under_way_.run->next();
  const auto key = next ? next->key : 0;
  const blocks::Block block = next ? next->block : under_way_.run->block();
  if (result.failed()) {
    under_way_.run->commandEnded(key, toOutcome(block, blocks::Ending::Aborted, result.failure), now);
  } else {
    const std::string words = fmt::format("{}; {}", stopping_->why, result.words());
    under_way_.run->commandEnded(key, blocks::commandAborted(words), now);
  }
}

bool Turns::takeOut(blocks::GoalId goal, const std::string& why, Instant now) {
  return under_way_.run && under_way_.run->chain() != nullptr &&
         under_way_.run->chain()->takeOut(goal, why, now);
}

void Turns::abandon(const std::string& why, Instant now) {
  if (under_way_.run) under_way_.run->cancel(why, now);
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
  interrupt(why, now);
}

void Turns::stopAll(const std::string& why, blocks::GoalId newest, Instant now) {
  if (!desks_.window.stopsWithACancel()) desks_.stops.ask(now);
  abortAll(why, newest, now);
}

// --- Events.

void Turns::linkLost(const std::string& reason, Instant now) {
  desks_.window.linkLost(reason, now);
  const auto patience =
      parts_.robot.status() ? std::optional(parts_.settings.evidence_timeout) : std::nullopt;
  if (under_way_.run) under_way_.run->linkLost(reason, patience, now);
}

void Turns::robotChanged(Instant now) {
  desks_.window.robotChanged(now);
  if (!under_way_.run) return;
  under_way_.run->robotChanged(parts_.robot, now);
  if (const auto why = under_way_.run->stopsFor()) cancelWindow(*why, now);
}

void Turns::advance(Instant now) {
  desks_.window.advance(now);
  parts_.jog.serve(under_way_.run ? under_way_.run->jog() : nullptr, now);
  if (under_way_.run) under_way_.run->advance(now);
}

std::optional<Instant> Turns::nextDeadline() const {
  const auto next = desks_.window.nextDeadline();
  return under_way_.run ? earlier(next, under_way_.run->nextDeadline()) : next;
}

// --- What the goals that wait are told.

void Turns::tellPlaces() {
  desks_.queue.tellPlaces([this](int place) { return occupancy_.textOfPlace(place); });
}

}  // namespace cobot_command::command
