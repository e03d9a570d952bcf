// The queue: who waits, who is next, and what falls with whom.

#include <algorithm>
#include <cassert>
#include <utility>

#include "core_impl.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

/// Nothing is known that speaks against it; it is only not known enough.
bool couldNotBePlanned(const blocks::Outcome& found) {
  return found.error_id == blocks::own_error::kStartUnknown ||
         found.error_id == blocks::own_error::kNoModel || found.error_id == blocks::own_error::kBaseUnknown;
}

/// How the ScriptExit() behind a motion ended, with what is to be told of the motion.
blocks::Outcome withMotion(const blocks::Outcome& exit, const blocks::Outcome& motion) {
  blocks::Outcome outcome = motion;
  outcome.ending = exit.ending;
  outcome.error_id = exit.error_id;
  outcome.remedy = exit.remedy;
  if (exit.ending != blocks::Ending::Done) {
    outcome.error_description =
        exit.error_description + " (the motion was done, the Listen node was to be left)";
  }
  return outcome;
}

}  // namespace

// --- Planning ahead.

std::optional<Origin> CommandCore::Impl::originBehindAll(Instant now) const {
  if (!waiting_.empty()) return waiting_.back().end;
  if (!run_ || run_->leavesTheRobot()) return forecast_.origin(now);
  const bool known = run_->isOneCommand() && on_wire_ && on_wire_->order().plan && !on_wire_->stopping();
  return known ? std::make_optional(on_wire_->order().plan->end) : std::nullopt;
}

/// What was foreseen for those that wait stands on what was in front of them.
void CommandCore::Impl::forgetForecasts() {
  for (Waiting& waiting : waiting_) waiting.end.reset();
}

// --- In and out.

void CommandCore::Impl::enqueue(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode,
                                Instant now) {
  const blocks::Block block = blocks::blockOf(goal);
  if (mode == blocks::BufferMode::Aborting) {
    abortAll(fmt::format("taken over by {}", toString(block)), id, now);
    if (mayMoveOtherwise() && !stop_.busy()) askForStop(now);
  }
  Waiting waiting;
  waiting.id = id;
  waiting.goal = goal;
  waiting.takes_over = mode == blocks::BufferMode::Aborting && stop_.busy();
  if (busyBlock()) {
    if (const auto command = blocks::GoalRules(goal).command()) {
      const auto planned = forecast_.plan(*command, originBehindAll(now));
      if (!planned) {
        reject(id, goal, {planned.error()});
        return;
      }
      if (*planned) waiting.end = (*planned)->end;
    }
  }
  board_.wait(block, id);
  waiting_.push_back(std::move(waiting));
}

void CommandCore::Impl::dropWaiting(const std::string& why, blocks::GoalId newest) {
  if (newest > fell_.newest) {
    fell_ = {newest, why};
    actions_.emplace_back(fell_);
  }
  for (const Waiting& waiting : std::exchange(waiting_, {})) {
    static_cast<void>(plans_.drop(waiting.id));
    endAborted(blocks::blockOf(waiting.goal), waiting.id, why);
  }
}

/// A take-over is in front of all others, as it has dropped what waited.
void CommandCore::Impl::dropUnstopped(const std::string& found) {
  const std::string why = fmt::format("{}: {}", robot::LooseMotion::kMayStillMove, found);
  std::optional<Waiting> take_over;
  if (!waiting_.empty() && waiting_.front().takes_over) {
    take_over = std::move(waiting_.front());
    waiting_.pop_front();
  }
  dropWaiting(why);
  if (!take_over) return;
  const blocks::Block block = blocks::blockOf(take_over->goal);
  board_.end(block, take_over->id,
             blocks::toRejection(block, {{blocks::own_error::kStopNotConfirmed, why, ""}}));
}

void CommandCore::Impl::abortAll(const std::string& why, blocks::GoalId newest, Instant now) {
  dropWaiting(why, newest);
  abortRunning(why, now);
}

void CommandCore::Impl::abortRunning(const std::string& why, Instant now) {
  if (!run_ || on_wire_) forecast_.forgetPath();  // else it stays as it is
  if (run_) run_->cancel(why, now);
  if (on_wire_) on_wire_->cancel(why, now);
}

void CommandCore::Impl::endAborted(blocks::Block block, blocks::GoalId id, const std::string& why) {
  board_.end(block, id, blocks::commandAborted(why));
}

// --- Whose turn it is.

void CommandCore::Impl::dispatch(Instant now) {
  while (life_ == Life::Working && !on_wire_ && !stop_.busy() && !holdsBack()) {
    if (run_) {
      if (!continueRun(now)) return;
    } else if (!waiting_.empty()) {
      if (!beginNext(now)) return;
    } else {
      return;
    }
    finishCommand(now);
    finishRun(now);
  }
}

/// Nothing (false) as long as it is planned as a whole.
bool CommandCore::Impl::beginNext(Instant now) {
  Waiting& first = waiting_.front();
  const Failures failures = objectionsTo(first);
  if (failures.empty() && !first.found && blocks::GoalRules(first.goal).isPlanned()) {
    if (first.job == 0) {
      first.job = askForPlan(first.id, first.goal, forecast_.origin(now), PlanDesk::Haste::Turn);
      first.told_place = 0;  // what it waits for is another thing now
    }
    if (!first.found) return false;
  }
  const Waiting next = std::move(waiting_.front());
  waiting_.pop_front();
  if (failures.empty()) {
    begin(next, now);
  } else {
    static_cast<void>(plans_.drop(next.id));
    refuseTurn(next, toRejection(blockOf(next.goal), failures));
  }
  return true;
}

CommandCore::Impl::Failures CommandCore::Impl::objectionsTo(const Waiting& next) const {
  Failures failures = checkReadiness(blocks::BufferMode::Aborting);
  const bool has_waited = next.told_place > 0;
  if (failures.empty() && has_waited) {
    if (auto moved = blocks::GoalRules(next.goal).findMovedFrame(frame_finder_)) {
      failures.push_back(std::move(*moved));
    }
  }
  return failures;
}

void CommandCore::Impl::begin(const Waiting& next, Instant now) {
  blocks::Outcome found = next.found.value_or(blocks::Outcome());
  if (found.ending == blocks::Ending::Rejected && !couldNotBePlanned(found)) {
    refuseTurn(next, std::move(found));
    return;
  }
  auto run = blocks::GoalRules(next.goal).run(next.id, found, now);
  if (run->isOneCommand()) {
    beginCommand(next, std::move(run), now);
  } else {
    board_.accept(run->block(), next.id, 0);
    run_ = std::move(run);
    run_->robotChanged(robot_, now);
  }
}

void CommandCore::Impl::beginCommand(const Waiting& next, std::unique_ptr<blocks::Run> run, Instant now) {
  auto order = prepare(*run->next(), now);
  if (!order) {
    refuseTurn(next, toRejection(run->block(), {order.error()}));
    return;
  }
  board_.accept(run->block(), next.id, order->command_id_ack);
  run_ = std::move(run);
  startNext(std::move(*order), now);
}

/// What waits behind it stands on where it would have left the robot. When it has not waited itself, nothing
/// waits behind it: it is refused as it comes, like a goal that is wrong by itself, and takes none with it.
void CommandCore::Impl::refuseTurn(const Waiting& next, blocks::Outcome refusal) {
  const blocks::Block block = blocks::blockOf(next.goal);
  if (next.told_place > 0) {
    dropWaiting(fmt::format("the command in front of it, {}, was refused", toString(block)));
  }
  board_.end(block, next.id, std::move(refusal));
}

Result<CommandOrder, blocks::Failure> CommandCore::Impl::prepare(const blocks::Command& command,
                                                                 Instant now) {
  const blocks::GoalTraits& traits = command.traits;
  auto prepared = forecast_.order(command, now);
  if (!prepared) return refuse(prepared.error());
  CommandOrder order = std::move(*prepared);
  // A tag is opened last, for what will be sent.
  if (traits.awaits_motion) {
    order.tag = tags_.open(traits.command_id);
    if (!order.tag) return refuse(blocks::Failure{blocks::own_error::kNoFreeTag, "", ""});
  }
  order.command_id_ack = traits.command_id != 0 ? traits.command_id : order.tag.value_or(0);
  order.exits_node = traits.exits_node && !order.tag;
  order.exits_afterwards = traits.exits_node && order.tag;
  addLastLines(order);
  return order;
}

void CommandCore::Impl::startNext(CommandOrder order, Instant now) {
  order.goal = run_->goal();
  run_->commandStarted();
  start(std::move(order), now);
}

void CommandCore::Impl::start(CommandOrder order, Instant now) {
  forecast_.sent(order, now);
  orphan_.fire(robot::OrphanEvent::Commanded);
  on_wire_.emplace(std::move(order), contextOfRuns(), now);
}

/// Nothing (false) as long as the run has nothing to send.
bool CommandCore::Impl::continueRun(Instant now) {
  const auto command = run_->next();
  if (!command) return false;
  if (command->leaves_only && !checkLink().empty()) {
    run_->commandEnded({}, now);  // the flow has left the node by itself
    return true;
  }
  auto order = prepareNext(*command, now);
  if (order) {
    startNext(std::move(*order), now);
  } else {
    run_->commandRefused(order.error(), now);
  }
  return true;
}

Result<CommandOrder, blocks::Failure> CommandCore::Impl::prepareNext(const blocks::Command& command,
                                                                     Instant now) {
  const Failures failures = checkReadiness(blocks::BufferMode::Aborting);
  if (!failures.empty()) return refuse(failures.front());
  if (command.find_moved_frame) {
    if (auto moved = command.find_moved_frame(frame_finder_)) return refuse(std::move(*moved));
  }
  return prepare(command, now);
}

// --- Ends.

void CommandCore::Impl::finishDirectRuns(Instant now) {
  const char* unanswered = nullptr;
  for (const CommandRun& run : direct_) {
    if (!run.ended()) continue;
    const bool got_no_reply = run.outcome().error_id == blocks::motion_error::kReceiveReply;
    if (got_no_reply && run.order().stops_unanswered) unanswered = toString(run.order().block);
    board_.end(run.order().block, run.order().goal, run.outcome());
  }
  direct_.remove_if([](const CommandRun& run) { return run.ended(); });
  if (unanswered != nullptr) {
    stopAll(fmt::format("stopped, as {} got no reply", unanswered), newestGoal(), now);
  }
}

void CommandCore::Impl::leaveNode(const CommandRun& done, Instant now) {
  before_exit_ = done.outcome();
  CommandOrder exit;
  exit.block = done.order().block;
  exit.goal = done.order().goal;
  exit.command_id_ack = done.order().command_id_ack;
  exit.commands.emplace();
  exit.exits_node = true;
  addLastLines(exit);
  start(std::move(exit), now);
}

void CommandCore::Impl::finishCommand(Instant now) {
  finishDirectRuns(now);
  if (!on_wire_) return;
  for (const blocks::Progress& progress : on_wire_->takeProgress()) run_->commandProgressed(progress);
  if (!on_wire_->ended()) return;
  const CommandRun done = *std::exchange(on_wire_, std::nullopt);
  const auto before_exit = std::exchange(before_exit_, std::nullopt);
  const bool leaves = done.order().exits_afterwards && run_->leavesNode();
  if (leaves && done.outcome().ending == blocks::Ending::Done && checkLink().empty()) {
    leaveNode(done, now);
    return;
  }
  const blocks::Outcome outcome = before_exit ? withMotion(done.outcome(), *before_exit) : done.outcome();
  if (outcome.ending == blocks::Ending::Aborted) {
    robot_.takeBackAcknowledgement();
    forecast_.forgetPath();
  }
  run_->commandEnded(outcome, now);
  run_->robotChanged(robot_, now);
}

void CommandCore::Impl::finishRun(Instant now) {
  if (!run_) return;
  for (blocks::Progress& progress : run_->takeProgress()) {
    board_.progress(run_->block(), run_->goal(), std::move(progress));
  }
  if (!run_->outcome()) return;
  assert(!on_wire_);
  const auto done = std::exchange(run_, nullptr);
  if (done->outcome()->ending == blocks::Ending::Aborted) {
    if (done->leavesMotions()) stopIfMoving(now);
    // Before the end of the goal itself: its error is what the block shows then.
    dropWaiting(fmt::format("the command in front of it, {}, failed", toString(done->block())));
  }
  board_.end(done->block(), done->goal(), *done->outcome());
}

std::string CommandCore::Impl::textOfPlace(int place) const {
  if (place > 1) return "waits for its turn, others are in front of it";
  if (run_) return "waits for its turn, one is in front of it";
  if (plansTheNext()) return "is planned as a whole, before its first move";
  return holdsBack() ? fmt::format("waits until the robot stands: {}", heldBackBy())
                     : "waits for its turn, until the robot stands";
}

void CommandCore::Impl::tellPlaces() {
  int place = 0;
  for (Waiting& waiting : waiting_) {
    ++place;
    if (waiting.told_place == place) continue;
    waiting.told_place = place;
    blocks::Progress progress;
    progress.phase = blocks::Phase::Queued;
    progress.place_in_queue = place;
    progress.text = textOfPlace(place);
    board_.progress(blocks::blockOf(waiting.goal), waiting.id, std::move(progress));
  }
}

}  // namespace cobot_command::command
