// The queue: who waits, who is next, and what falls with whom.

#include <algorithm>
#include <utility>

#include "core_impl.h"
#include "moved_frames.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

template <class Kind>
constexpr bool kIsQueued = !std::is_same_v<Kind, ConnectGoal> && !std::is_same_v<Kind, ProgramControlGoal> &&
                           !std::is_same_v<Kind, StopGoal> && !std::is_same_v<Kind, CheckSequenceGoal> &&
                           !std::is_same_v<Kind, PickAndPlaceGoal>;

/// Calls `use` with a goal that is one command; anything else is answered with `otherwise`.
template <class Answer, class Use>
Answer forCommand(const Goal& goal, Answer otherwise, Use use) {
  return std::visit(
      [&](const auto& g) -> Answer {
        if constexpr (kIsQueued<std::decay_t<decltype(g)>>) {
          return use(g);
        } else {
          return std::move(otherwise);
        }
      },
      goal);
}

/// How the ScriptExit() behind a motion ended, with what is to be told of the motion.
Outcome withMotion(const Outcome& exit, const Outcome& motion) {
  Outcome outcome = motion;
  outcome.ending = exit.ending;
  outcome.error_id = exit.error_id;
  outcome.remedy = exit.remedy;
  if (exit.ending != Ending::Done) {
    outcome.error_description =
        exit.error_description + " (the motion was done, the Listen node was to be left)";
  }
  return outcome;
}

}  // namespace

// --- Planning ahead.

std::optional<Origin> CommandCore::Impl::originBehindAll(Instant now) const {
  if (!waiting_.empty()) return waiting_.back().end;
  if (cycle_) return std::nullopt;
  if (run_) {
    const bool known = run_->order().plan && !run_->stopping();
    return known ? std::make_optional(run_->order().plan->end) : std::nullopt;
  }
  return originNow(now);
}

Result<std::optional<Plan>, Failure> CommandCore::Impl::planFor(const Goal& goal,
                                                                const std::optional<Origin>& origin) const {
  using Planned = Result<std::optional<Plan>, Failure>;
  return forCommand<Planned>(goal, std::optional<Plan>(), [&](const auto& command) -> Planned {
    const auto base = origin ? origin->start.base : frames_.frames().base;
    if (traitsOf(command).needs_base && !base) return refuse(Failure{own_error::kBaseUnknown, "", ""});
    const CommandOrder order = orderOf(command, base.value_or(arm::Pose::Identity()));
    if (!origin || !order.commands) return std::optional<Plan>();
    return preflight_.plan(*order.commands, *origin);
  });
}

/// What was foreseen for those that wait stands on what was in front of them.
void CommandCore::Impl::forgetForecasts() {
  for (Waiting& waiting : waiting_) waiting.end.reset();
}

// --- In and out.

void CommandCore::Impl::enqueue(GoalId id, const Goal& goal, BufferMode mode, Instant now) {
  const Block block = blockOf(goal);
  if (mode == BufferMode::Aborting) {
    abortAll(fmt::format("taken over by {}", toString(block)), id, now);
    if (mayMoveOtherwise() && !stop_.busy()) askForStop(now);
  }
  Waiting waiting{id, goal, mode == BufferMode::Aborting && stop_.busy(), 0, std::nullopt};
  if (busyBlock()) {
    const auto planned = planFor(goal, originBehindAll(now));
    if (!planned) {
      board_.reject(block, id, toRejection(block, {planned.error()}));
      return;
    }
    if (*planned) waiting.end = (*planned)->end;
  }
  board_.wait(block, id);
  waiting_.push_back(std::move(waiting));
}

void CommandCore::Impl::dropWaiting(const std::string& why, GoalId newest) {
  if (newest > fell_.newest) {
    fell_ = {newest, why};
    actions_.emplace_back(fell_);
  }
  for (const Waiting& waiting : std::exchange(waiting_, {})) {
    endAborted(blockOf(waiting.goal), waiting.id, why);
  }
}

/// A take-over is in front of all others, as it has dropped what waited.
void CommandCore::Impl::dropUnstopped(const std::string& found) {
  const std::string why = fmt::format("{}: {}", LooseMotion::kMayStillMove, found);
  std::optional<Waiting> take_over;
  if (!waiting_.empty() && waiting_.front().takes_over) {
    take_over = std::move(waiting_.front());
    waiting_.pop_front();
  }
  dropWaiting(why);
  if (!take_over) return;
  const Block block = blockOf(take_over->goal);
  board_.end(block, take_over->id, toRejection(block, {{own_error::kStopNotConfirmed, why, ""}}));
}

void CommandCore::Impl::abortAll(const std::string& why, GoalId newest, Instant now) {
  dropWaiting(why, newest);
  abortRunning(why, now);
}

void CommandCore::Impl::abortRunning(const std::string& why, Instant now) {
  preflight_.forget();
  if (cycle_) cycle_->cancel(why, now);
  if (run_) run_->cancel(why, now);
}

void CommandCore::Impl::endAborted(Block block, GoalId id, const std::string& why) {
  Outcome outcome;
  outcome.ending = Ending::CommandAborted;
  outcome.error_description = why;
  board_.end(block, id, std::move(outcome));
}

// --- Whose turn it is.

void CommandCore::Impl::dispatch(Instant now) {
  while (life_ == Life::Working && !run_ && !stop_.busy() && !holdsBack()) {
    if (cycle_) {
      if (!cycle_->next()) return;
      continueCycle(now);
    } else if (!waiting_.empty()) {
      const Waiting next = std::move(waiting_.front());
      waiting_.pop_front();
      begin(next, now);
    } else {
      return;
    }
    finishRuns(now);
    finishCycle(now);
  }
}

void CommandCore::Impl::begin(const Waiting& next, Instant now) {
  const Block block = blockOf(next.goal);
  Failures failures = checkReadiness(BufferMode::Aborting);
  const bool has_waited = next.told_place > 0;
  if (failures.empty() && has_waited) {
    if (auto refusal = refusalOfMovedFrame(next.goal, frame_finder_)) {
      refuseTurn(next, std::move(*refusal));
      return;
    }
  }
  if (failures.empty()) {
    if (const auto* cycle = std::get_if<PickAndPlaceGoal>(&next.goal)) {
      beginCycle(next, *cycle, now);
      return;
    }
    auto order = prepare(next.goal, now);
    if (order) {
      order->goal = next.id;
      board_.accept(block, next.id, order->command_id_ack);
      start(std::move(*order), now);
      return;
    }
    failures.push_back(order.error());
  }
  refuseTurn(next, toRejection(block, failures));
}

/// What waits behind it stands on where it would have left the robot. When it has not waited itself, nothing
/// waits behind it: it is refused as it comes, like a goal that is wrong by itself, and takes none with it.
void CommandCore::Impl::refuseTurn(const Waiting& next, Outcome refusal) {
  const Block block = blockOf(next.goal);
  if (next.told_place > 0) {
    dropWaiting(fmt::format("the command in front of it, {}, was refused", toString(block)));
  }
  board_.end(block, next.id, std::move(refusal));
}

Result<CommandOrder, Failure> CommandCore::Impl::prepare(const Goal& goal, Instant now) {
  using Prepared = Result<CommandOrder, Failure>;
  return forCommand<Prepared>(goal, CommandOrder(), [&](const auto& command) -> Prepared {
    const CommandTraits traits = traitsOf(command);
    const ActiveFrames frames = frames_.frames();
    if (traits.needs_base && !frames.base) return refuse(Failure{own_error::kBaseUnknown, "", ""});
    CommandOrder order = orderOf(command, frames.base.value_or(arm::Pose::Identity()));
    if (order.commands) {
      auto plan = preflight_.plan(*order.commands, originNow(now));
      if (!plan) return refuse(plan.error());
      order.plan = std::move(*plan);
      order.target = order.plan ? order.plan->target : jointTargetOf(*order.commands);
    }
    if (traits.awaits_motion) {
      order.tag = tags_.open(traits.command_id);
      if (!order.tag) return refuse(Failure{own_error::kNoFreeTag, "", ""});
    }
    order.command_id_ack = traits.command_id != 0 ? traits.command_id : order.tag.value_or(0);
    order.exits_node = traits.exits_node && !order.tag;
    order.exits_afterwards = traits.exits_node && order.tag;
    order.reply_timeout = traits.reply_timeout;
    addLastLines(order);
    return order;
  });
}

void CommandCore::Impl::start(CommandOrder order, Instant now) {
  if (order.moves) {
    if (order.tag) {
      preflight_.forget();
    } else {
      preflight_.queue(order.plan, now);
    }
  }
  if (order.plan) tellPath(order.goal, *order.plan);
  orphan_.fire(OrphanEvent::Commanded);
  run_.emplace(std::move(order), contextOfRuns(), now);
}

// --- Pick and place.

void CommandCore::Impl::beginCycle(const Waiting& next, const PickAndPlaceGoal& goal, Instant now) {
  Outcome found = checkCycle(goal, originNow(now));
  const bool not_checkable = found.error_id == own_error::kStartUnknown ||
                             found.error_id == own_error::kNoModel ||
                             found.error_id == own_error::kBaseUnknown;
  if (found.ending == Ending::Rejected && !not_checkable) {
    refuseTurn(next, std::move(found));
    return;
  }
  board_.accept(Block::PickAndPlace, next.id, 0);
  cycle_.emplace(next.id, goal, std::move(found.steps), now);
}

void CommandCore::Impl::continueCycle(Instant now) {
  const auto command = *cycle_->next();
  if (std::holds_alternative<ExitListenNodeGoal>(command) && !checkLink().empty()) {
    cycle_->commandEnded({}, now);  // the flow has left the node by itself
    return;
  }
  auto order = prepareStep(command, now);
  if (!order) {
    cycle_->commandRefused(order.error(), now);
    return;
  }
  order->goal = cycle_->goal();
  cycle_->commandStarted();
  start(std::move(*order), now);
}

/// To prepare a move opens a tag for it, so it comes last.
Result<CommandOrder, Failure> CommandCore::Impl::prepareStep(const PickAndPlaceRun::Command& command,
                                                             Instant now) {
  const Failures failures = checkReadiness(BufferMode::Aborting);
  if (!failures.empty()) return refuse(failures.front());
  if (const auto* output = std::get_if<OutputAction>(&command)) return orderOf(*output);
  const auto* move = std::get_if<MoveAbsoluteGoal>(&command);
  if (move == nullptr) return prepare(std::get<ExitListenNodeGoal>(command), now);
  if (const auto moved = findMovedFrame(*move, frame_finder_)) return refuse(*moved);
  return prepare(*move, now);
}

// --- Ends.

void CommandCore::Impl::finishDirectRuns(Instant now) {
  const char* unanswered = nullptr;
  for (const CommandRun& run : direct_) {
    if (!run.ended()) continue;
    if (run.outcome().error_id == motion_error::kReceiveReply) unanswered = toString(run.order().block);
    board_.end(run.order().block, run.order().goal, run.outcome());
  }
  direct_.remove_if([](const CommandRun& run) { return run.ended(); });
  if (unanswered != nullptr) {
    stopAll(fmt::format("stopped, as {} got no reply", unanswered), newestGoal(), now);
  }
}

void CommandCore::Impl::tellProgress() {
  for (Progress& progress : run_->takeProgress()) {
    if (cycle_) {
      cycle_->commandProgressed(progress);
    } else {
      board_.progress(run_->order().block, run_->order().goal, std::move(progress));
    }
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

void CommandCore::Impl::finishRuns(Instant now) {
  finishDirectRuns(now);
  if (!run_) return;
  tellProgress();
  if (!run_->ended()) return;
  const CommandRun run = *std::exchange(run_, std::nullopt);
  const auto before_exit = std::exchange(before_exit_, std::nullopt);
  const bool leaves = run.order().exits_afterwards && (!cycle_ || cycle_->leavesNode());
  if (leaves && run.outcome().ending == Ending::Done && checkLink().empty()) {
    leaveNode(run, now);
    return;
  }
  const Outcome outcome = before_exit ? withMotion(run.outcome(), *before_exit) : run.outcome();
  if (outcome.ending == Ending::Aborted) {
    robot_.takeBackAcknowledgement();
    preflight_.forget();
    // Before the end of the command itself: its error is what the block shows then.
    dropWaiting(fmt::format("the command in front of it, {}, failed",
                            toString(cycle_ ? Block::PickAndPlace : run.order().block)));
  }
  if (cycle_) {
    cycle_->commandEnded(outcome, now);
  } else {
    board_.end(run.order().block, run.order().goal, outcome);
  }
}

void CommandCore::Impl::finishCycle(Instant now) {
  if (!cycle_) return;
  for (Progress& progress : cycle_->takeProgress()) {
    board_.progress(Block::PickAndPlace, cycle_->goal(), std::move(progress));
  }
  if (!cycle_->ended()) return;
  const PickAndPlaceRun cycle = *std::exchange(cycle_, std::nullopt);
  if (cycle.outcome().ending == Ending::Aborted) {
    stopIfMoving(now);
    dropWaiting("the command in front of it, pick_and_place, failed");
  }
  board_.end(Block::PickAndPlace, cycle.goal(), cycle.outcome());
}

std::string CommandCore::Impl::textOfPlace(int place) const {
  if (place > 1) return "waits for its turn, others are in front of it";
  if (run_ || cycle_) return "waits for its turn, one is in front of it";
  return holdsBack() ? fmt::format("waits until the robot stands: {}", heldBackBy())
                     : "waits for its turn, until the robot stands";
}

void CommandCore::Impl::tellPlaces() {
  int place = 0;
  for (Waiting& waiting : waiting_) {
    ++place;
    if (waiting.told_place == place) continue;
    waiting.told_place = place;
    Progress progress;
    progress.phase = Phase::Queued;
    progress.place_in_queue = place;
    progress.text = textOfPlace(place);
    board_.progress(blockOf(waiting.goal), waiting.id, std::move(progress));
  }
}

}  // namespace cobot_command::blocks
