#include "arbiter/turns.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

/// Nothing is known that speaks against it; it is only not known enough.
bool couldNotBePlanned(blocks::Block block, const blocks::Outcome& found) {
  const int id = generalErrorId(block, found.error_id);
  return id == blocks::own_error::kStartUnknown || id == blocks::own_error::kNoModel ||
         id == blocks::own_error::kBaseUnknown;
}

}  // namespace

Turns::Turns(const CoreParts& parts, const Desks& desks, blocks::FrameFinder frames)
    : parts_(parts),
      desks_(desks),
      occupancy_(parts, desks.queue, desks.stops, desks.window, run_, std::move(frames)),
      next_(parts.settings, parts.forecast, desks.planning,
            [this](Instant now) { return occupancy_.originNow(now); }) {}

// --- Begins.

void Turns::dispatch(Instant now) {
  while (!desks_.stops.busy() && !desks_.stops.holdsBack()) {
    const bool went_on = run_ ? continueRun(now) || joinNext(now) : beginNext(now);
    if (!went_on) return;
    settle(now);
  }
}

bool Turns::beginNext(Instant now) {
  if (!desks_.window.empty() || desks_.queue.empty()) return false;
  if (occupancy_.isHeldBack(desks_.queue.front())) {
    // What was planned of it is planned anew when it goes on, with all the time that a plan has.
    if (desks_.queue.plansTheNext()) next_.forget();
    desks_.queue.forgetTurn();
    return false;
  }
  return !parts_.hold.holdsBack(desks_.queue.front().id, desks_.queue.motions()) && admitNext(now);
}

bool Turns::joinNext(Instant now) {
  return !desks_.queue.empty() && run_->chain() != nullptr &&
         run_->chain()->isJoinedBy(blockOf(desks_.queue.front().goal)) &&
         !occupancy_.isHeldBack(desks_.queue.front()) && admitNext(now);
}

bool Turns::admitNext(Instant now) {
  Waiting& first = desks_.queue.front();
  const Failures failures = occupancy_.objectionsTo(first);
  if (failures.empty() && isBeingPlanned(first, now)) return false;
  Waiting next = desks_.queue.take();
  if (failures.empty()) {
    admit(std::move(next), now);
  } else {
    refuseTurn(next, toRejection(blockOf(next.goal), failures));
  }
  return true;
}

bool Turns::isBeingPlanned(Waiting& first, Instant now) {
  using Turn = Waiting::Turn;
  const blocks::GoalRules rules(first.goal);
  if (const auto command = rules.command()) {
    first.turn = Turn::PlansCommand;
    return next_.look(*command, first.id, now) == NextCommand::State::Planning;
  }
  if (rules.isPlanned() && first.turn == Turn::NotYet) {
    first.turn = Turn::PlansWhole;
    first.told_place = 0;  // what it waits for is another thing now
    if (auto use = rules.uses()) first.hold = parts_.tables.hold(*std::move(use));
    desks_.plans.planTheNext(run_ ? run_->chain()->end() : blocks::Detail(), now);
  }
  return rules.isPlanned() && !first.found;
}

void Turns::admit(Waiting next, Instant now) {
  const blocks::Outcome found = next.found.value_or(blocks::Outcome());
  const blocks::GoalRules rules(next.goal);
  const bool may_do_without = !rules.traits().needs_plan && couldNotBePlanned(blockOf(next.goal), found);
  if (found.ending == blocks::Ending::Rejected && !may_do_without) {
    refuseTurn(next, found);
  } else if (run_) {
    join(std::move(next), found, now);
  } else {
    begin(next, found, now);
  }
}

/// One whose plan is of a chain that has gone on since is the next one again.
void Turns::join(Waiting next, const blocks::Outcome& found, Instant now) {
  const blocks::GoalId id = next.id;
  if (run_->chain()->join(id, found, now)) {
    parts_.board.accept(run_->block(), id, 0);
    holds_[id] = next.hold;
    return;
  }
  next.found.reset();
  next.turn = Waiting::Turn::NotYet;
  desks_.queue.putBack(std::move(next));
}

void Turns::begin(const Waiting& next, const blocks::Outcome& found, Instant now) {
  desks_.queue.forgetPlan(next.id);  // what was to be foreseen is there
  auto run = blocks::GoalRules(next.goal).run(next.id, found, now);
  if (run->isOneCommand()) {
    beginCommand(next, std::move(run), now);
  } else {
    parts_.board.accept(run->block(), next.id, 0);
    holds_[next.id] = next.hold;
    run_ = std::move(run);
    desks_.paths.serve(*run_, now);
    run_->robotChanged(parts_.robot, now);
  }
}

void Turns::beginCommand(const Waiting& next, std::unique_ptr<blocks::Run> run, Instant now) {
  if (const auto failure = prepare(*run->next(), now)) {
    refuseTurn(next, toRejection(run->block(), {*failure}));
    return;
  }
  parts_.board.accept(run->block(), next.id, next_.order().command_id_ack);
  run_ = std::move(run);
  send(now);
}

/// What waits behind it stands on where it would have left the robot. When it has not waited itself, it is
/// refused as it comes, like a goal that is wrong by itself, and takes none with it, also not those that came
/// while it was planned.
void Turns::refuseTurn(const Waiting& next, blocks::Outcome refusal) {
  const blocks::Block block = blocks::blockOf(next.goal);
  desks_.queue.forgetPlan(next.id);
  next_.forget();
  if (next.told_place > 0) {
    desks_.queue.dropAll(fmt::format("the command in front of it, {}, was refused", toString(block)));
  }
  parts_.board.end(block, next.id, std::move(refusal));
}

/// Nothing (false) as long as the run has nothing to send, or that is planned.
bool Turns::continueRun(Instant now) {
  if (desks_.window.size() >= run_->window() || !desks_.window.goesOn()) return false;
  if (finishes_behind_motion_) {
    if (parts_.forecast.loose().mayMove() && parts_.robot.tellsMotion()) return false;
    finishes_behind_motion_ = false;
    run_->finish(blocks::FinishAfter::Move, now);
    return true;
  }
  const auto command = run_->next();
  if (!command) return false;
  // What it sets back behind itself, say, still goes out.
  const bool is_held = parts_.speed.isZero() || parts_.permit.interrupts();
  if (is_held && command->order(arm::Pose::Identity()).moves) {
    next_.forget();  // its plan is made anew when it goes on, with all the time that a plan has
    return false;
  }
  if (command->leaves_only && !parts_.keeper.objectionsToCommands().empty()) {
    run_->commandEnded(command->key, {}, now);  // the flow has left the node by itself
    return true;
  }
  auto failure = occupancy_.objectionTo(*command);
  if (!failure) {
    if (next_.look(*command, run_->goal(), now) == NextCommand::State::Planning) return false;
    failure = prepare(*command, now);
  }
  if (failure) {
    next_.forget();
    run_->commandRefused(command->key, *failure, now);
  } else {
    send(now);
  }
  return true;
}

std::optional<blocks::Failure> Turns::prepare(const blocks::Command& command, Instant now) {
  if (next_.failure()) return next_.failure();
  return desks_.window.prepare(next_.order(), command.traits, now);
}

void Turns::send(Instant now) {
  CommandOrder order = std::move(next_.order());
  next_.forget();
  order.goal = run_->goal();
  run_->commandStarted(order.key);
  desks_.stops.commanded();
  desks_.window.send(std::move(order), now);
}

// --- Ends.

void Turns::settle(Instant now) {
  for (const auto& [key, progress] : desks_.window.takeProgress()) {
    run_->commandProgressed(key, progress, now);
  }
  for (const auto& [key, mark] : desks_.window.takePassed()) run_->commandPassed(key, mark, now);
  while (auto ended = desks_.window.takeEnded(now)) endCommand(std::move(*ended), now);
  if (run_) desks_.paths.serve(*run_, now);
  endRun(now);
}

void Turns::endCommand(CommandWindow::Ended ended, Instant now) {
  if (ended.leaves_node && run_->leavesNode() && parts_.keeper.objectionsToCommands().empty()) {
    desks_.stops.commanded();
    desks_.window.leaveNode(std::move(ended), now);
    return;
  }
  if (ended.outcome.ending == blocks::Ending::Aborted) parts_.robot.takeBackAcknowledgement();
  run_->commandEnded(ended.key, ended.outcome, now);
  run_->robotChanged(parts_.robot, now);
}

void Turns::tellRun() {
  blocks::RunReports& reports = run_->reports();
  for (auto& [goal, progress] : reports.takeProgress()) {
    parts_.board.progress(run_->block(), goal, std::move(progress));
  }
  for (auto& news : reports.takeNews()) parts_.actions.emplace_back(RunTold{run_->block(), std::move(news)});
  for (auto& [goal, outcome] : reports.takeEnded()) {
    holds_.erase(goal);
    parts_.board.end(run_->block(), goal, std::move(outcome));
  }
}

void Turns::endRun(Instant now) {
  if (!run_) return;
  tellRun();
  if (!run_->outcome()) return;
  assert(desks_.window.empty());
  next_.forget();
  desks_.paths.leave();
  parts_.jog.serve(run_->jog(), now);
  stopping_.reset();
  finishes_behind_motion_ = false;
  const auto done = std::exchange(run_, nullptr);
  desks_.queue.forgetTurn();  // what was to join it begins by itself
  holds_.clear();
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
  if (run_) run_->cancel(why, now);
  cancelWindow(why, now);
}

void Turns::interrupt(const std::string& why, Instant now) {
  if (!run_ || isBetweenCommands()) {
    cancel(why, now);
    return;
  }
  run_->interrupt(why, now);
  cancelWindow(why, now);
}

void Turns::cancelWindow(const std::string& why, Instant now) {
  if (!run_ || !desks_.window.empty()) parts_.forecast.forgetPath();  // else it stays as it is
  desks_.window.cancel(why, now);
}

bool Turns::isBetweenCommands() const {
  return run_ && !run_->outcome() && !run_->leavesTheRobot() && desks_.window.empty() &&
         parts_.forecast.loose().mayMove();
}

/// To the goal it is as if its last command was still under way: it ends with what becomes of the robot.
void Turns::stopBetweenCommands(const std::string& why, Instant now) {
  if (stopping_) return;
  next_.forget();
  if (!desks_.stops.busy()) desks_.stops.ask(now);
  if (!desks_.stops.busy()) {  // nobody hears it
    run_->cancel(why, now);
    return;
  }
  stopping_ = Stopping{desks_.stops.last(), why};
  blocks::Progress progress;
  progress.phase = blocks::Phase::Stopping;
  progress.text = why + ", stopping the robot";
  run_->commandProgressed(0, progress, now);
}

void Turns::stopEnded(const StopRun::Result& result, Instant now) {
  if (!stopping_ || stopping_->stop != result.number || !run_ || run_->outcome()) return;
  const auto next = run_->next();
  const auto key = next ? next->key : 0;
  const blocks::Block block = next ? next->block : run_->block();
  if (result.failed()) {
    run_->commandEnded(key, toOutcome(block, blocks::Ending::Aborted, result.failure), now);
  } else {
    const std::string words = fmt::format("{}; {}", stopping_->why, result.words());
    run_->commandEnded(key, blocks::commandAborted(words), now);
  }
}

bool Turns::takeOut(blocks::GoalId goal, const std::string& why, Instant now) {
  return run_ && run_->chain() != nullptr && run_->chain()->takeOut(goal, why, now);
}

void Turns::abandon(const std::string& why, Instant now) {
  if (run_) run_->cancel(why, now);
  desks_.window.abandon(why, now);
  settle(now);
  if (!run_) return;
  // What it would set back behind itself is not sent any more.
  if (const auto last = run_->next()) {
    run_->commandRefused(last->key, {blocks::own_error::kShutDown, why, ""}, now);
  }
}

void Turns::finish(blocks::FinishAfter after, Instant now) {
  const bool behind_motion =
      after == blocks::FinishAfter::Move && isBetweenCommands() && parts_.robot.tellsMotion();
  if (behind_motion) {
    finishes_behind_motion_ = true;
  } else if (run_) {
    run_->finish(after, now);
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
  if (run_) run_->linkLost(reason, patience, now);
}

void Turns::robotChanged(Instant now) {
  desks_.window.robotChanged(now);
  if (!run_) return;
  run_->robotChanged(parts_.robot, now);
  if (const auto why = run_->stopsFor()) cancelWindow(*why, now);
}

void Turns::advance(Instant now) {
  desks_.window.advance(now);
  parts_.jog.serve(run_ ? run_->jog() : nullptr, now);
  if (run_) run_->advance(now);
}

std::optional<Instant> Turns::nextDeadline() const {
  const auto next = desks_.window.nextDeadline();
  return run_ ? earlier(next, run_->nextDeadline()) : next;
}

// --- What the goals that wait are told.

void Turns::tellPlaces() {
  desks_.queue.tellPlaces([this](int place) { return occupancy_.textOfPlace(place); });
}

}  // namespace cobot_command::command
