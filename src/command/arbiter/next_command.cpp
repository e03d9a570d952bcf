#include "arbiter/next_command.h"

#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

bool NextCommand::isAsked(const blocks::Command& command, blocks::GoalId goal) const {
  return asked_ && asked_->goal == goal && asked_->key == command.key;
}

NextCommand::State NextCommand::look(const blocks::Command& command, blocks::GoalId goal, Instant now) {
  if (!isAsked(command, goal)) return make(command, goal, now);
  if (!asked_->answered) return State::Planning;
  if (!asked_->planned) return refuse({blocks::own_error::kPlanningBudget, "", ""});
  const Origin origin = forecast_.origin(now);
  if (isSameStart(asked_->planned->origin, origin)) return take(*asked_->planned, origin);
  return make(command, goal, now);
}

NextCommand::State NextCommand::make(const blocks::Command& command, blocks::GoalId goal, Instant now) {
  forget();
  auto order = forecast_.order(command);
  if (!order) return refuse(order.error());
  order_ = std::move(*order);
  if (!order_.commands) return State::Ready;
  const Origin origin = forecast_.origin(now);
  if (forecast_.isPlannedAtOnce(order_)) return take(*forecast_.plan(order_, origin), origin);
  ask(goal, origin, now);
  return asked_->answered ? take(*asked_->planned, origin) : State::Planning;
}

void NextCommand::ask(blocks::GoalId goal, const Origin& origin, Instant now) {
  asked_ = Asked{goal, order_.key};
  const auto take = [this, goal, key = order_.key](std::optional<PlanAnswer> answer) {
    if (!asked_ || asked_->goal != goal || asked_->key != key) return;
    asked_->answered = true;
    if (answer) asked_->planned = std::move(answer->command);
  };
  desk_.drop(goal);  // what was foreseen of it
  desk_.ask({order_.block, goal, PlanDesk::Purpose::Send, forecast_.workFor(order_, origin), take}, now);
}

NextCommand::State NextCommand::take(PlannedCommand& planned, const Origin& now) {
  if (!planned.plan) return refuse(planned.plan.error());
  takePlan(order_, planned, now);
  return State::Ready;
}

NextCommand::State NextCommand::refuse(blocks::Failure failure) {
  asked_.reset();
  failure_ = std::move(failure);
  return State::Refused;
}

void NextCommand::forget() {
  if (asked_) desk_.drop(asked_->goal);
  asked_.reset();
  failure_.reset();
}

}  // namespace cobot_command::command
