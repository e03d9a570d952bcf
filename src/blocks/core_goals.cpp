// Goals: checked, then refused or taken.

#include <algorithm>
#include <cassert>
#include <utility>

#include "check_sequence.h"
#include "core_impl.h"
#include "joint_path.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr const char* kShuttingDown = "the command layer is shutting down";

/// It can only take motion away from the robot. So it is never too late for it, as long as there is a wire.
bool halts(const Goal& goal) {
  const auto* control = std::get_if<ProgramControlGoal>(&goal);
  const bool pauses = control != nullptr && control->command == static_cast<int>(ProgramCommand::Pause);
  return pauses || std::holds_alternative<StopGoal>(goal);
}

void append(std::vector<Failure>& failures, const std::vector<Failure>& more) {
  failures.insert(failures.end(), more.begin(), more.end());
}

void sortByTable(std::vector<Failure>& failures) {
  std::stable_sort(failures.begin(), failures.end(),
                   [](const Failure& a, const Failure& b) { return a.error_id < b.error_id; });
}

}  // namespace

void CommandCore::Impl::submit(GoalId id, const Goal& goal, Instant now) {
  newest_submitted_ = std::max(newest_submitted_, id);
  const bool fell = id <= fell_.newest && fallsWithOthers(goal);
  if (life_ == Life::Retiring && !halts(goal)) {
    abortAsItComes(blockOf(goal), id, kShuttingDown);
  } else if (life_ == Life::Over) {
    board_.reject(blockOf(goal), id, toRejection(blockOf(goal), {{own_error::kShutDown, "", ""}}));
  } else if (fell) {
    abortAsItComes(blockOf(goal), id, fell_.why);
  } else {
    std::visit([&](const auto& g) { execute(id, g, now); }, goal);
  }
  settle(now);
}

void CommandCore::Impl::abortAsItComes(Block block, GoalId id, const std::string& why) {
  board_.wait(block, id);
  endAborted(block, id, why);
}

void CommandCore::Impl::execute(GoalId id, const ConnectGoal& goal, Instant now) {
  Failures failures = checkConnect(goal);
  const auto busy = connect_.busy() ? busyBlock() : std::nullopt;
  const bool leaves_a_motion =
      connect_.busy() && !connect_.isSameController(goal) && (loose_.mayMove() || stop_.busy());
  const auto target = fmt::format("{}:{}", connect_.target().host, connect_.target().port);
  if (!connect_.mayExecute()) {
    failures.push_back(
        {own_error::kConnectBusy,
         connect_.disconnecting() ? fmt::format("the link to {} is being closed", target) : "with " + target,
         ""});
  } else if (busy) {
    failures.push_back({own_error::kConnectBusy,
                        fmt::format("the link to {} is used by {}", target, toString(*busy)),
                        "Wait for its end, or cancel it, then connect"});
  } else if (leaves_a_motion) {
    failures.push_back({own_error::kConnectBusy, fmt::format("the robot at {} may still move", target),
                        "Stop that robot first (stop), or wait until it stands"});
  }
  if (!failures.empty()) {
    board_.reject(Block::Connect, id, toRejection(Block::Connect, failures));
    return;
  }
  kept_no_more_ = false;
  connect_.execute(id, goal, now);
}

template <class CommandGoal>
void CommandCore::Impl::execute(GoalId id, const CommandGoal& goal, Instant now) {
  const CommandTraits traits = traitsOf(goal);
  Failures failures = check(goal);
  if (traits.check_only) {
    checkOnly(id, goal, std::move(failures), now);
    return;
  }
  append(failures, checkReadiness(traits.buffer_mode));
  sortByTable(failures);
  if (failures.empty()) {
    enqueue(id, goal, traits.buffer_mode, now);
  } else {
    const Block block = blockOf(Goal(goal));
    board_.reject(block, id, toRejection(block, failures));
  }
}

void CommandCore::Impl::checkOnly(GoalId id, const Goal& goal, Failures failures, Instant now) {
  const Block block = blockOf(goal);
  std::optional<Plan> plan;
  if (failures.empty()) {
    auto planned = planFor(goal, originBehindAll(now));
    if (!planned) {
      failures.push_back(planned.error());
    } else if (!*planned) {
      failures.push_back(preflight_.arm() ? Failure{own_error::kStartUnknown, "", ""}
                                          : Failure{own_error::kNoModel, "", ""});
    } else {
      plan = std::move(**planned);
    }
  }
  if (!failures.empty()) {
    board_.reject(block, id, toRejection(block, failures));
    return;
  }
  Outcome outcome;
  outcome.planned = plan->duration;
  outcome.joint_path = jointPath(plan->motions);
  tellPath(id, *plan);
  board_.answer(block, id, std::move(outcome));
}

void CommandCore::Impl::execute(GoalId id, const ProgramControlGoal& goal, Instant now) {
  Failures failures = check(goal);
  append(failures, connect_.disconnecting() ? checkLink() : checkConnection());
  sortByTable(failures);
  if (!failures.empty()) {
    board_.reject(Block::ProgramControl, id, toRejection(Block::ProgramControl, failures));
    return;
  }
  CommandOrder order = orderOf(goal);
  order.goal = id;
  order.command_id_ack = goal.command_id;
  board_.accept(order.block, id, order.command_id_ack);
  direct_.emplace_back(std::move(order), contextOfRuns(), now);
}

void CommandCore::Impl::execute(GoalId id, const StopGoal& /*goal*/, Instant now) {
  constexpr const char* kWhy = "stopped by the stop block";
  dropWaiting(kWhy, id);  // also when there is nobody who could be told to stop
  const Failures failures = checkConnection();
  if (!failures.empty()) {
    board_.reject(Block::Stop, id, toRejection(Block::Stop, failures));
    return;
  }
  board_.accept(Block::Stop, id, 0);
  Progress progress;
  progress.phase = Phase::Stopping;
  progress.text = "stopping the robot";
  board_.progress(Block::Stop, id, std::move(progress));
  stopAll(kWhy, id, now);
  stop_goals_.push_back({id, stop_.last()});
}

void CommandCore::Impl::execute(GoalId id, const CheckSequenceGoal& goal, Instant now) {
  Outcome outcome = checkSequence(goal, preflight_.arm(), originBehindAll(now));
  if (outcome.ending == Ending::Rejected) {
    board_.reject(Block::CheckSequence, id, std::move(outcome));
    return;
  }
  board_.answer(Block::CheckSequence, id, std::move(outcome));
}

void CommandCore::Impl::execute(GoalId id, const PickAndPlaceGoal& goal, Instant now) {
  const auto mode = static_cast<BufferMode>(goal.buffer_mode);
  Failures failures = checkPickAndPlace(goal);
  if (!goal.check_only) append(failures, checkReadiness(mode));
  sortByTable(failures);
  if (!failures.empty()) {
    board_.reject(Block::PickAndPlace, id, toRejection(Block::PickAndPlace, failures));
    return;
  }
  if (!goal.check_only) {
    enqueue(id, goal, mode, now);
    return;
  }
  Outcome outcome = checkCycle(goal, originBehindAll(now));
  if (outcome.ending == Ending::Rejected) {
    board_.reject(Block::PickAndPlace, id, std::move(outcome));
    return;
  }
  board_.answer(Block::PickAndPlace, id, std::move(outcome));
}

Outcome CommandCore::Impl::checkCycle(const PickAndPlaceGoal& goal,
                                      const std::optional<Origin>& origin) const {
  Outcome outcome = checkSequence(asSequence(goal), preflight_.arm(), origin);
  if (outcome.ending != Ending::Rejected) {
    outcome.planned = plannedCycle(goal, outcome.steps);
    return outcome;
  }
  // The same findings, in the words of this block.
  const ErrorEntry* entry = findError(Block::PickAndPlace, outcome.error_id);
  assert(entry != nullptr);
  const bool is_general = outcome.remedy == findError(Block::CheckSequence, outcome.error_id)->remedy;
  if (is_general) outcome.remedy = entry->remedy;
  return outcome;
}

CommandCore::Impl::Failures CommandCore::Impl::checkLink() const {
  if (connect_.disconnecting()) {
    return {{motion_error::kNotConnected, "the connection is being closed", ""}};
  }
  if (!connect_.busy() || !script_.established()) {
    return {{motion_error::kNotConnected, linkDiagnosis(), ""}};
  }
  if (script_.state() != link::ScriptLinkState::Ready) {
    return {{own_error::kNotListening, script_.diagnosis(), ""}};
  }
  return {};
}

CommandCore::Impl::Failures CommandCore::Impl::checkConnection() const {
  if (script_.connected()) return {};
  return {{motion_error::kNotConnected, linkDiagnosis(), ""}};
}

CommandCore::Impl::Failures CommandCore::Impl::checkReadiness(BufferMode mode) const {
  Failures failures = checkLink();
  if (failures.empty() && !connect_.ready()) {
    return {{motion_error::kNotConnected, "the first status frame is still awaited", "Wait for it"}};
  }
  if (!failures.empty() && failures.front().error_id == motion_error::kNotConnected) return failures;
  const auto busy = busyBlock();
  if (mode == BufferMode::Refuse && busy) {
    failures.push_back({motion_error::kOtherBlockBusy, toString(*busy), ""});
  }
  if (mode == BufferMode::Buffered && waiting_.size() >= kMostWaiting) {
    failures.push_back(tooManyWait(waiting_.size()));
  }
  if (robot_.emergencyStop()) failures.push_back({own_error::kEmergencyStop, "", ""});
  if (robot_.inError()) failures.push_back(robotError(robot_));
  if (mode == BufferMode::Refuse && holdsBack() && !stop_.busy()) {
    failures.push_back({own_error::kOrphanMoves, heldBackBy(), ""});
  }
  return failures;
}

std::optional<Block> CommandCore::Impl::busyBlock() const {
  if (!stop_goals_.empty()) return Block::Stop;
  if (cycle_) return Block::PickAndPlace;
  if (run_) return run_->order().block;
  if (!waiting_.empty()) return blockOf(waiting_.front().goal);
  return std::nullopt;
}

void CommandCore::Impl::cancel(GoalId id, Instant now, std::optional<GoalId> newest) {
  const auto waiting =
      std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& w) { return w.id == id; });
  if (waiting != waiting_.end()) {
    const Block block = blockOf(waiting->goal);
    waiting_.erase(waiting);
    forgetForecasts();
    endAborted(block, id, "cancelled before its turn");
  } else if (cycle_ ? cycle_->goal() == id : run_ && run_->order().goal == id) {
    const Block block = cycle_ ? Block::PickAndPlace : run_->order().block;
    dropWaiting(fmt::format("the command in front of it, {}, was cancelled", toString(block)),
                newest.value_or(newestGoal()));
    abortRunning("cancelled", now);
  } else if (connect_.busy() && connect_.goal() == id) {
    if (kept_) kept_no_more_ = true;
    connect_.cancel(now);
    abortAll("the connection is being closed", newest.value_or(newestGoal()), now);
    stopIfMoving(now);
  }
  settle(now);
}

FinishReport CommandCore::Impl::finish(FinishAfter after, Instant now, std::optional<GoalId> newest) {
  FinishReport found;
  found.dropped = static_cast<int>(waiting_.size());
  found.moves_on = loose_.mayMove();
  dropWaiting(kNothingBehindFinish, newest.value_or(newestGoal()));
  found.under_way = busyBlock();
  if (cycle_) cycle_->finish(after, now);
  settle(now);
  return found;
}

void CommandCore::Impl::keepConnected(const ConnectGoal& target, Instant now) {
  kept_ = target;
  kept_no_more_ = false;
  settle(now);
}

void CommandCore::Impl::retire(Instant now) {
  if (life_ != Life::Working) return;
  life_ = Life::Retiring;
  kept_.reset();
  abortAll(kShuttingDown, newestGoal(), now);
  stopIfMoving(now);
  settle(now);
}

bool CommandCore::Impl::retired() const {
  return life_ != Life::Working && !run_ && !cycle_ && direct_.empty() && !stop_.busy();
}

void CommandCore::Impl::shutDown(Instant now) {
  const std::string why = stop_.busy() ? fmt::format(
                                             "{}; the robot was told to stop, and did not confirm it in "
                                             "the time there was: it may still move",
                                             kShuttingDown)
                                       : kShuttingDown;
  life_ = Life::Over;
  kept_.reset();
  dropWaiting(why);
  if (cycle_) cycle_->cancel(why, now);
  if (run_) run_->abandon(why, now);
  stopIfMoving(now);
  for (CommandRun& run : direct_) run.abandon(why, now);
  finishRuns(now);
  finishCycle(now);
  for (const StopWish& wish : std::exchange(stop_goals_, {})) endAborted(Block::Stop, wish.id, why);
  connect_.abandon(why, now);
  settle(now);
}

}  // namespace cobot_command::blocks
