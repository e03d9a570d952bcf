#include "sending/next_command.h"

#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

bool NextCommand::isAsked(const blocks::Command& command, blocks::GoalId goal) const {
  return asked_ && asked_->goal == goal && asked_->key == command.key;
}

NextCommand::State NextCommand::look(const blocks::Command& command, blocks::GoalId goal, Instant now) {
  if (!isAsked(command, goal)) return make(command, goal, now, now);
  if (!asked_->answered) return State::Planning;
  if (!asked_->planned) return refuse({blocks::own_error::kPlanningBudget, "", ""});
  const Origin origin = origin_(now);
  const bool has_its_speed = asked_->speed_share == forecast_.speedShare();
  if (has_its_speed && isStillGood(*asked_->planned, origin)) return take(*asked_->planned, origin);
  if (now - asked_->first < settings_.planning_budget) return make(command, goal, asked_->first, now);
  return refuse(
      {blocks::own_error::kPlanningBudget, "its start changed each time before its plan was complete", ""});
}

NextCommand::State NextCommand::make(const blocks::Command& command, blocks::GoalId goal, Instant first,
                                     Instant now) {
  forget();
  auto order = forecast_.order(command);
  if (!order) return refuse(order.error());
  order_ = std::move(*order);
  const Origin origin = origin_(now);
  if (!order_.commands) {
    order_.unplanned = forecast_.whyUnplanned(order_, origin);
    return State::Ready;
  }
  if (forecast_.isPlannedAtOnce(order_)) return take(*forecast_.plan(order_, origin), origin);
  ask({goal, order_.key, first, forecast_.speedShare()}, origin, now);
  return asked_->answered ? take(*asked_->planned, origin) : State::Planning;
}

void NextCommand::ask(const Asked& asked, const Origin& origin, Instant now) {
  asked_ = asked;
  const auto take = [this, goal = asked.goal, key = asked.key](std::optional<PlanAnswer> answer) {
    if (!asked_ || asked_->goal != goal || asked_->key != key) return;
    asked_->answered = true;
    if (answer) asked_->planned = std::move(answer->command);
  };
  desk_.drop(asked.goal);  // what was foreseen of it
  desk_.ask({order_.block, asked.goal, PlanDesk::Purpose::Send, forecast_.workFor(order_, origin), take},
            now);
}

NextCommand::State NextCommand::take(PlannedCommand& planned, const Origin& now) {
  if (!planned.plan) return refuse(planned.plan.error());
  takePlan(order_, planned, now);
  if (!order_.plan) order_.unplanned = forecast_.whyUnplanned(order_, now);
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
