#include "arbiter/goal_plans.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

using Purpose = PlanDesk::Purpose;

namespace {

PlanAnswer tookTooLong(blocks::Block block) {
  return {toRejection(block, {{blocks::own_error::kPlanningBudget, "", ""}}), {}};
}

}  // namespace

void GoalPlans::check(blocks::GoalId id, const blocks::Goal& goal, const blocks::Detail& chain, Instant now) {
  const auto take = [this, block = blockOf(goal), id](std::optional<PlanAnswer> answer) {
    this->answer(block, id, answer ? *std::move(answer) : tookTooLong(block));
  };
  tellDifferences(goal);
  const Ticket ticket = queue_.lastTicket();
  const bool is_known = isOriginKnown(ticket);
  blocks::PlanningScene scene = sceneOf(goal);
  scene.chain = chain;
  auto make = parts_.forecast.workFor(goal, is_known ? originNow(ticket, now) : originThen(ticket), scene);
  auto is_ready = [this, ticket] { return isOriginKnown(ticket); };
  desk_.ask({blockOf(goal), id, Purpose::Check, std::move(make), take,
             is_known ? std::function<bool()>() : is_ready},
            now);
}

void GoalPlans::tellDifferences(const blocks::Goal& goal) {
  const auto use = blocks::GoalRules(goal).uses();
  const std::string differences = use ? parts_.sync.differencesIn(*use) : "";
  if (differences.empty()) return;
  parts_.actions.emplace_back(LogMessage{
      Severity::Warning,
      fmt::format("{} is planned with the values of this node: {}", toString(blockOf(goal)), differences)});
}

/// But for what the forecast knows.
blocks::PlanningScene GoalPlans::sceneOf(const blocks::Goal& goal) const {
  blocks::PlanningScene scene;
  scene.program = program_;
  scene.number = parts_.board.accepted(blockOf(goal)) + 1;
  scene.feedrate = parts_.paths.served().feedrate;
  scene.is_pvt_refused = parts_.paths.isPvtRefused();
  scene.is_velocity_refused = parts_.jog.isVelocityRefused();
  scene.velocities = parts_.settings.velocities;
  scene.jog_stop_time = parts_.settings.jog_stop_time;
  scene.angle_tolerance = parts_.settings.angle_tolerance;
  scene.path = parts_.settings.path;
  scene.driven = parts_.paths.driven(parts_.keeper.run().target());
  return scene;
}

bool GoalPlans::isOriginKnown(Ticket ticket) const {
  const Waiting* const before = queue_.lastBefore(ticket);
  return before == nullptr || !desk_.plans(before->id);
}

Forecast::OriginAt GoalPlans::originNow(Ticket ticket, Instant now) const {
  return [origin = origin_behind_(ticket, now)](Instant /*then*/) { return origin; };
}

Forecast::OriginAt GoalPlans::originThen(Ticket ticket) const {
  return [this, ticket](Instant then) { return origin_behind_(ticket, then); };
}

void GoalPlans::show(blocks::Block block, blocks::GoalId id, blocks::Detail preview) {
  if (!preview.isNone()) parts_.actions.emplace_back(GoalPreviewed{block, id, std::move(preview)});
}

void GoalPlans::answer(blocks::Block block, blocks::GoalId id, PlanAnswer answer) {
  show(block, id, std::move(answer.preview));
  if (answer.outcome.ending == blocks::Ending::Rejected) {
    parts_.board.reject(block, id, std::move(answer.outcome));
    return;
  }
  if (!answer.tool_path.empty()) {
    parts_.actions.emplace_back(PathPlanned{id, std::move(answer.tool_path)});
  }
  parts_.board.answer(block, id, std::move(answer.outcome));
}

void GoalPlans::foresee(Instant now) {
  const Waiting& last = queue_.back();
  const auto command = blocks::GoalRules(last.goal).command();
  if (!command) return;
  const auto take = [this, id = last.id](const std::optional<PlanAnswer>& answer) {
    takeForesight(id, answer ? answer->command.get() : nullptr);
  };
  desk_.ask(
      {command->block, last.id, Purpose::Foresee, parts_.forecast.workFor(*command, originThen(last.ticket)),
       take, [this, ticket = last.ticket] { return isOriginKnown(ticket); }},
      now);
}

/// Refused as it comes, like a goal that is wrong by itself: it takes none with it.
void GoalPlans::takeForesight(blocks::GoalId id, const PlannedCommand* planned) {
  Waiting* const waiting = queue_.find(id);
  if (waiting == nullptr || planned == nullptr) return;
  if (!planned->plan) {
    queue_.refuse(id, toRejection(blockOf(waiting->goal), {planned->plan.error()}));
  } else if (*planned->plan) {
    waiting->end = (*planned->plan)->end;
  }
}

void GoalPlans::planTheNext(const blocks::Detail& chain, Instant now) {
  const Waiting& first = queue_.front();
  const auto origin = [this](Instant then) { return parts_.forecast.origin(then); };
  const auto take = [this, block = blockOf(first.goal), id = first.id](std::optional<PlanAnswer> answer) {
    Waiting* const waiting = queue_.find(id);
    if (waiting == nullptr) return;
    PlanAnswer found = answer ? *std::move(answer) : tookTooLong(block);
    show(block, id, std::move(found.preview));
    waiting->found = std::move(found.outcome);
  };
  tellDifferences(first.goal);
  blocks::PlanningScene scene = sceneOf(first.goal);
  scene.chain = chain;
  desk_.ask({blockOf(first.goal), first.id, Purpose::Send, parts_.forecast.workFor(first.goal, origin, scene),
             take},
            now);
}

bool GoalPlans::cancel(blocks::GoalId goal) {
  const auto check = desk_.dropCheck(goal);
  if (check) endUnplanned(*check, "cancelled while it was planned");
  return check.has_value();
}

void GoalPlans::endAll(const std::string& why) {
  for (const PlanDesk::Job& check : desk_.dropChecks()) endUnplanned(check, why);
}

void GoalPlans::endUnplanned(const PlanDesk::Job& check, const std::string& why) {
  parts_.board.reject(check.block, check.goal, blocks::commandAborted(why));
}

}  // namespace cobot_command::command
