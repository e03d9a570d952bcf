// Goals: checked, then refused or taken.

#include <algorithm>
#include <utility>

#include "core_impl.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::command {
namespace {

constexpr const char* kShuttingDown = "the command layer is shutting down";

void append(std::vector<blocks::Failure>& failures, const std::vector<blocks::Failure>& more) {
  failures.insert(failures.end(), more.begin(), more.end());
}

void sortByTable(std::vector<blocks::Failure>& failures) {
  std::stable_sort(failures.begin(), failures.end(), [](const blocks::Failure& a, const blocks::Failure& b) {
    return a.error_id < b.error_id;
  });
}

}  // namespace

void CommandCore::Impl::submit(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  newest_submitted_ = std::max(newest_submitted_, id);
  const bool fell = id <= fell_.newest && fallsWithOthers(goal);
  if (life_ == Life::Retiring && !blocks::GoalRules(goal).traits().halts) {
    abortAsItComes(blocks::blockOf(goal), id, kShuttingDown);
  } else if (life_ == Life::Over) {
    board_.reject(blocks::blockOf(goal), id,
                  blocks::toRejection(blocks::blockOf(goal), {{blocks::own_error::kShutDown, "", ""}}));
  } else if (fell) {
    abortAsItComes(blocks::blockOf(goal), id, fell_.why);
  } else {
    execute(id, goal, now);
  }
  settle(now);
}

void CommandCore::Impl::abortAsItComes(blocks::Block block, blocks::GoalId id, const std::string& why) {
  board_.wait(block, id);
  endAborted(block, id, why);
}

void CommandCore::Impl::execute(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
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

void CommandCore::Impl::connect(blocks::GoalId id, const blocks::Goal& wanted, Instant now) {
  const auto& goal = std::get<blocks::ConnectGoal>(wanted);
  Failures failures = check(goal);
  const auto busy = connect_.busy() ? busyBlock() : std::nullopt;
  const bool leaves_a_motion =
      connect_.busy() && !connect_.isSameController(goal) && (forecast_.loose().mayMove() || stop_.busy());
  const auto target = fmt::format("{}:{}", connect_.target().host, connect_.target().port);
  if (!connect_.mayExecute()) {
    failures.push_back(
        {blocks::own_error::kConnectBusy,
         connect_.disconnecting() ? fmt::format("the link to {} is being closed", target) : "with " + target,
         ""});
  } else if (busy) {
    failures.push_back({blocks::own_error::kConnectBusy,
                        fmt::format("the link to {} is used by {}", target, toString(*busy)),
                        "Wait for its end, or cancel it, then connect"});
  } else if (leaves_a_motion) {
    failures.push_back({blocks::own_error::kConnectBusy,
                        fmt::format("the robot at {} may still move", target),
                        "Stop that robot first (stop), or wait until it stands"});
  }
  if (!failures.empty()) {
    reject(id, wanted, failures);
    return;
  }
  kept_no_more_ = false;
  connect_.execute(id, goal, now);
}

void CommandCore::Impl::reject(blocks::GoalId id, const blocks::Goal& goal, const Failures& failures) {
  const blocks::Block block = blockOf(goal);
  board_.reject(block, id, toRejection(block, failures));
}

void CommandCore::Impl::queueUp(blocks::GoalId id, const blocks::Goal& goal, blocks::BufferMode mode,
                                Instant now) {
  Failures failures = blocks::GoalRules(goal).violations();
  append(failures, checkReadiness(mode));
  sortByTable(failures);
  if (failures.empty()) {
    enqueue(id, goal, mode, now);
  } else {
    reject(id, goal, failures);
  }
}

void CommandCore::Impl::answerByPlan(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const blocks::GoalRules rules(goal);
  Failures failures = rules.violations();
  sortByTable(failures);
  if (!failures.empty()) {
    reject(id, goal, failures);
    return;
  }
  static_cast<void>(askForPlan(id, goal, originBehindAll(now), PlanDesk::Haste::Check));
}

void CommandCore::Impl::sendBeside(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  const blocks::GoalRules rules(goal);
  Failures failures = rules.violations();
  const bool only_connection = rules.traits().tried_anyway && !connect_.disconnecting();
  append(failures, only_connection ? checkConnection() : checkLink());
  if (!rules.traits().tried_anyway && robot_.emergencyStop()) {
    failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
  }
  sortByTable(failures);
  if (!failures.empty()) {
    reject(id, goal, failures);
    return;
  }
  const blocks::Command command = *rules.command();
  CommandOrder order;
  static_cast<blocks::Order&>(order) = command.order(arm::Pose::Identity());
  order.block = command.block;
  order.goal = id;
  order.command_id_ack = command.traits.command_id;
  order.beside = true;
  board_.accept(order.block, id, order.command_id_ack);
  direct_.emplace_back(std::move(order), contextOfRuns(), now);
}

void CommandCore::Impl::stopOnRequest(blocks::GoalId id, const blocks::Goal& goal, Instant now) {
  constexpr const char* kWhy = "stopped by the stop block";
  dropWaiting(kWhy, id);  // also when there is nobody who could be told to stop
  const Failures failures = checkConnection();
  if (!failures.empty()) {
    reject(id, goal, failures);
    return;
  }
  board_.accept(kStop, id, 0);
  blocks::Progress progress;
  progress.phase = blocks::Phase::Stopping;
  progress.text = "stopping the robot";
  board_.progress(kStop, id, std::move(progress));
  stopAll(kWhy, id, now);
  stop_goals_.push_back({id, stop_.last()});
}

CommandCore::Impl::Failures CommandCore::Impl::checkLink() const {
  if (connect_.disconnecting()) {
    return {{blocks::motion_error::kNotConnected, "the connection is being closed", ""}};
  }
  if (!connect_.busy() || !script_.established()) {
    return {{blocks::motion_error::kNotConnected, linkDiagnosis(), ""}};
  }
  if (script_.state() != link::ScriptLinkState::Ready) {
    return {{blocks::own_error::kNotListening, script_.diagnosis(), ""}};
  }
  return {};
}

CommandCore::Impl::Failures CommandCore::Impl::checkConnection() const {
  if (script_.connected()) return {};
  return {{blocks::motion_error::kNotConnected, linkDiagnosis(), ""}};
}

CommandCore::Impl::Failures CommandCore::Impl::checkReadiness(blocks::BufferMode mode) const {
  Failures failures = checkLink();
  if (failures.empty() && !connect_.ready()) {
    return {{blocks::motion_error::kNotConnected, "the first status frame is still awaited", "Wait for it"}};
  }
  if (!failures.empty() && failures.front().error_id == blocks::motion_error::kNotConnected) return failures;
  const auto busy = busyBlock();
  if (mode == blocks::BufferMode::Refuse && busy) {
    failures.push_back({blocks::motion_error::kOtherBlockBusy, toString(*busy), ""});
  }
  if (mode == blocks::BufferMode::Buffered && waiting_.size() >= kMostWaiting) {
    failures.push_back(blocks::tooManyWait(waiting_.size()));
  }
  if (robot_.emergencyStop()) failures.push_back({blocks::own_error::kEmergencyStop, "", ""});
  if (robot_.inError()) failures.push_back(blocks::robotError(robot_));
  if (mode == blocks::BufferMode::Refuse && holdsBack() && !stop_.busy()) {
    failures.push_back({blocks::own_error::kOrphanMoves, heldBackBy(), ""});
  }
  return failures;
}

std::optional<blocks::Block> CommandCore::Impl::busyBlock() const {
  if (!stop_goals_.empty()) return kStop;
  if (run_) return run_->block();
  if (!waiting_.empty()) return blockOf(waiting_.front().goal);
  return std::nullopt;
}

void CommandCore::Impl::cancel(blocks::GoalId id, Instant now, std::optional<blocks::GoalId> newest) {
  const auto waiting =
      std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& w) { return w.id == id; });
  if (waiting != waiting_.end()) {
    const blocks::Block block = blockOf(waiting->goal);
    waiting_.erase(waiting);
    static_cast<void>(plans_.drop(id));
    forgetForecasts();
    endAborted(block, id, "cancelled before its turn");
  } else if (const auto job = plans_.drop(id)) {
    endUnplanned(*job, "cancelled while it was planned");
  } else if (run_ && run_->goal() == id) {
    dropWaiting(fmt::format("the command in front of it, {}, was cancelled", toString(run_->block())),
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

FinishReport CommandCore::Impl::finish(blocks::FinishAfter after, Instant now,
                                       std::optional<blocks::GoalId> newest) {
  FinishReport found;
  found.dropped = static_cast<int>(waiting_.size());
  found.moves_on = forecast_.loose().mayMove();
  dropWaiting(kNothingBehindFinish, newest.value_or(newestGoal()));
  found.under_way = busyBlock();
  if (run_) run_->finish(after, now);
  settle(now);
  return found;
}

void CommandCore::Impl::keepConnected(const blocks::ConnectGoal& target, Instant now) {
  kept_ = target;
  kept_no_more_ = false;
  settle(now);
}

void CommandCore::Impl::retire(Instant now) {
  if (life_ != Life::Working) return;
  life_ = Life::Retiring;
  kept_.reset();
  abortAll(kShuttingDown, newestGoal(), now);
  endChecks(kShuttingDown);
  stopIfMoving(now);
  settle(now);
}

bool CommandCore::Impl::retired() const {
  return life_ != Life::Working && !run_ && direct_.empty() && !stop_.busy();
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
  endChecks(why);
  if (run_) run_->cancel(why, now);
  if (on_wire_) on_wire_->abandon(why, now);
  stopIfMoving(now);
  for (CommandRun& run : direct_) run.abandon(why, now);
  finishCommand(now);
  finishRun(now);
  for (const StopWish& wish : std::exchange(stop_goals_, {})) endAborted(kStop, wish.id, why);
  connect_.abandon(why, now);
  settle(now);
}

}  // namespace cobot_command::command
