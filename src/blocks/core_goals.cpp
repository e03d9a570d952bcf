// Goals: checked, refused or started.

#include <algorithm>

#include "core_impl.h"
#include "move_absolute.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::blocks {
namespace {

Block blockOf(const Goal& goal) {
  return static_cast<Block>(goal.index());
}

void sortByTable(std::vector<Failure>& failures) {
  std::stable_sort(failures.begin(), failures.end(),
                   [](const Failure& a, const Failure& b) { return a.error_id < b.error_id; });
}

}  // namespace

void CommandCore::Impl::submit(GoalId id, const Goal& goal, Instant now) {
  if (shut_down_) {
    board_.reject(blockOf(goal), id, toRejection(blockOf(goal), {{own_error::kShutDown, "", ""}}));
  } else {
    std::visit(Overloaded{[&](const ConnectGoal& g) { execute(id, g, now); },
                          [&](const MoveAbsoluteGoal& g) { execute(id, g, now); }, [](const auto&) {}},
               goal);
  }
  settle(now);
}

void CommandCore::Impl::execute(GoalId id, const ConnectGoal& goal, Instant now) {
  std::vector<Failure> failures = checkConnect(goal);
  if (connect_.busy()) {
    failures.push_back({own_error::kConnectBusy,
                        fmt::format("with {}:{}", connect_.target().host, connect_.target().port), ""});
  }
  if (!failures.empty()) {
    board_.reject(Block::Connect, id, toRejection(Block::Connect, failures));
    return;
  }
  connect_.execute(id, goal, now);
}

void CommandCore::Impl::execute(GoalId id, const MoveAbsoluteGoal& goal, Instant now) {
  std::vector<Failure> failures = checkReadiness();
  const std::vector<Failure> own = checkMoveAbsolute(goal);
  failures.insert(failures.end(), own.begin(), own.end());
  sortByTable(failures);

  MotionOrder order;
  order.block = Block::MoveAbsolute;
  if (failures.empty()) {
    auto plan = preflight_.plan(motionOf(goal), robot_, now);
    if (plan) {
      order.plan = *plan;
    } else {
      failures.push_back(plan.error());
    }
  }
  if (failures.empty() && !goal.blending_enable) {
    order.tag = tags_.open(goal.command_id);
    if (!order.tag) failures.push_back({own_error::kNoFreeTag, "", ""});
  }
  if (!failures.empty()) {
    Outcome outcome = toRejection(order.block, failures);
    board_.reject(order.block, id, std::move(outcome));
    return;
  }
  order.goal = id;
  order.command_id_ack = goal.command_id != 0 ? goal.command_id : order.tag.value_or(0);
  order.script = scriptOf(goal, order.tag);
  order.exits_node = goal.exit_node;
  start(std::move(order), now);
}

std::vector<Failure> CommandCore::Impl::checkReadiness() const {
  if (!connect_.busy() || connect_.disconnecting() || !script_.established()) {
    return {{motion_error::kNotConnected, script_.diagnosis(), ""}};
  }
  std::vector<Failure> failures;
  if (run_) {
    failures.push_back({motion_error::kOtherBlockBusy, toString(run_->order().block), ""});
  }
  if (script_.state() != link::ScriptLinkState::Ready) {
    failures.push_back({own_error::kNotListening, script_.diagnosis(), ""});
  }
  if (robot_.emergencyStop()) failures.push_back({own_error::kEmergencyStop, "", ""});
  if (robot_.inError()) failures.push_back({own_error::kRobotError, robot_.errorText(), ""});
  return failures;
}

void CommandCore::Impl::start(MotionOrder order, Instant now) {
  if (order.tag) {
    preflight_.forget();
  } else {
    preflight_.queue(order.plan, now);
  }
  run_.emplace(std::move(order), RunContext{settings_, script_, tags_, robot_, board_}, now);
}

void CommandCore::Impl::cancel(GoalId id, Instant now) {
  if (run_ && run_->order().goal == id) {
    preflight_.forget();
    run_->cancel(now);
  } else if (connect_.busy() && connect_.goal() == id) {
    connect_.cancel(now);
    if (run_) run_->cancel(now);
  }
  settle(now);
}

void CommandCore::Impl::shutDown(Instant now) {
  shut_down_ = true;
  if (run_) run_->abandon("the command layer is shutting down", now);
  connect_.abandon("the command layer is shutting down", now);
  settle(now);
}

}  // namespace cobot_command::blocks
