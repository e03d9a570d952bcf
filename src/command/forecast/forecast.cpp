#include "forecast/forecast.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/common/given.h"
#include "cobot_command/link/stream_items.h"

namespace cobot_command::command {
namespace {

/// What one command, planned, is answered with.
blocks::Outcome outcomeOf(blocks::Block block, const Planned& planned, const blocks::PlanningScene& scene) {
  if (!planned) return toRejection(block, {planned.error()});
  if (!*planned) {
    if (scene.arm == nullptr) return toRejection(block, {{blocks::own_error::kNoModel, "", ""}});
    return toRejection(block, {{blocks::own_error::kStartUnknown, scene.why_unknown, ""}});
  }
  blocks::Outcome outcome;
  outcome.planned = (*planned)->duration;
  outcome.detail = blocks::Detail(blocks::CheckedMotion{blocks::jointPath((*planned)->motions)});
  return outcome;
}

PlanAnswer planGoal(const blocks::Goal& goal, const blocks::PlanningScene& scene,
                    const std::optional<arm::Pose>& base, const std::optional<Origin>& origin) {
  const blocks::GoalRules rules(goal);
  const arm::ArmModel* const arm = scene.arm;
  if (auto whole = rules.plan(scene)) {
    blocks::Detail preview = rules.preview(*whole);
    return {std::move(*whole), {}, nullptr, std::move(preview)};
  }
  const blocks::Command command = *rules.command();
  const Planned plan = planFor(arm, command, base, scene.speed_share, origin, scene.give_up);
  PlanAnswer answer{outcomeOf(command.block, plan, scene), {}};
  if (plan && *plan) answer.tool_path = toolPathOf(**plan, *arm);
  return answer;
}

std::shared_ptr<PlannedCommand> planCommand(const arm::ArmModel* arm,
                                            const std::vector<script::ScriptCommand>& commands,
                                            const Origin& origin, const blocks::GiveUp& give_up) {
  // In its place at once: the moves of a Result must not fail, and that of a plan may, for want of memory.
  std::shared_ptr<PlannedCommand> planned(
      new PlannedCommand{origin, planFor(arm, commands, origin, give_up)});
  if (planned->plan && *planned->plan) planned->tool_path = toolPathOf(**planned->plan, *arm);
  return planned;
}

std::shared_ptr<PlannedCommand> foresee(const arm::ArmModel* arm, const blocks::Command& command,
                                        const std::optional<arm::Pose>& base, double speed_share,
                                        const std::optional<Origin>& origin, const blocks::GiveUp& give_up) {
  return std::shared_ptr<PlannedCommand>(new PlannedCommand{
      origin.value_or(Origin()), planFor(arm, command, base, speed_share, origin, give_up)});
}

/// Where motions leave the robot that no tag tells the end of.
robot::LooseMotion::End endOf(const CommandOrder& order) {
  if (!order.stands_at_end) return robot::LooseMotion::End::Never;
  const bool known = order.plan && order.plan->end.start.joints;
  return known ? robot::LooseMotion::End::Planned : robot::LooseMotion::End::Unknown;
}

}  // namespace

Forecast::Forecast(std::shared_ptr<const arm::ArmModel> arm, robot::RobotWatch& robot,
                   const tables::TableStore& tables, const SpeedOverride& speed, std::vector<Action>& actions)
    : arm_(std::move(arm)),
      limited_arm_(arm_),
      robot_(robot),
      tables_(tables),
      speed_(speed),
      actions_(actions) {}

/// What was queued has been planned with others.
void Forecast::useLimits(std::shared_ptr<const arm::ArmModel> limited_arm) {
  limited_arm_ = std::move(limited_arm);
  queue_.forget();
}

// --- Plans.

Origin Forecast::origin(Instant now) const {
  Origin origin;
  // Unknown are only frames of a name whose value the stream has not told yet. Where it tells nothing at all,
  // robot base and flange are what a project starts with.
  const robot::ActiveFrames active = frames();
  origin.start.base = active.base;
  if (!active.base && active.base_name.empty()) origin.start.base = arm::Pose::Identity();
  origin.start.tcp = active.tcp;
  if (!active.tcp && active.tcp_name.empty()) origin.start.tcp = arm::Pose::Identity();
  origin.frames_told = active.base && active.tcp;
  origin.start.speed_override = robot_.speedOverride();
  if (queue_.isUnderWay(robot_, now)) return queue_.endFrom(std::move(origin), now);
  // The stream shows a motion a little after its acceptance.
  const bool moves_to_unknown_place = robot_.moving().value_or(false) || loose_.endsUnknown();
  if (!moves_to_unknown_place) origin.start.joints = robot_.joints();
  return origin;
}

std::string Forecast::whyStartUnknown() const {
  if (!robot_.joints()) return robot_.whyNoJoints();
  if (robot_.moving().value_or(false)) return "the robot moves, and its destination is unknown";
  if (loose_.endsUnknown()) return "it follows a motion whose end is unknown";
  return "a command before it leaves the robot at an unknown position";
}

std::string Forecast::whyUnplanned(const CommandOrder& order, const Origin& origin) const {
  if (!order.moves || order.is_open_ended) return "";  // these have no plan
  if (!arm_) return "the command layer has no model of the arm";
  if (!order.commands) return "the command layer cannot interpret its lines";
  if (!origin.start.joints) return whyStartUnknown();
  const auto unknown = [](const char* what, const std::string& name, const char* item, bool is_streamed) {
    return fmt::format("the value of the active {}{} is not known{}", what,
                       name.empty() ? "" : " " + quoted(name),
                       is_streamed ? "" : ", because " + link::lackOf(item));
  };
  const robot::ActiveFrames active = frames();
  const auto& status = robot_.status();
  if (!origin.start.base) return unknown("base", active.base_name, "Base_Value", !status || status->base);
  if (!origin.start.tcp) return unknown("TCP", active.tcp_name, "TCP_Value", !status || robot_.tcp());
  return "the effect of its lines cannot be predicted";
}

Result<CommandOrder, blocks::Failure> Forecast::order(const blocks::Command& command) const {
  auto lines = linesOf(command, frames().base, speed_.share());
  if (!lines) return refuse(lines.error());
  CommandOrder order;
  static_cast<blocks::Order&>(order) = std::move(*lines);
  order.block = command.block;
  order.key = command.key;
  order.reply_timeout = command.traits.reply_timeout;
  order.evidence_timeout = command.traits.evidence_timeout;
  return order;
}

bool Forecast::isPlannedAtOnce(const CommandOrder& order) const {
  return !arm_ || !order.commands || !order.moves;
}

std::shared_ptr<PlannedCommand> Forecast::plan(const CommandOrder& order, const Origin& origin) const {
  return planCommand(limited_arm_.get(), *order.commands, origin, {});
}

PlanDesk::MakeWork Forecast::workFor(const CommandOrder& order, const Origin& origin) const {
  return [=, commands = *order.commands, arm = limited_arm_](const PlanDesk::Dropped& dropped,
                                                             Instant /*now*/) -> PlanWork {
    return [=]() -> PlanAnswer {
      return {{}, {}, planCommand(arm.get(), commands, origin, [dropped] { return dropped->load(); })};
    };
  };
}

PlanDesk::MakeWork Forecast::workFor(const blocks::Command& command, const OriginAt& origin_at) const {
  return [=](const PlanDesk::Dropped& dropped, Instant now) -> PlanWork {
    const auto origin = origin_at(now);
    return [=, arm = limited_arm_, base = baseAt(origin), share = speed_.share()]() -> PlanAnswer {
      return {
          {}, {}, foresee(arm.get(), command, base, share, origin, [dropped] { return dropped->load(); })};
    };
  };
}

PlanDesk::MakeWork Forecast::workFor(const blocks::Goal& goal, const OriginAt& origin_at,
                                     const blocks::PlanningScene& given) const {
  return [=](const PlanDesk::Dropped& dropped, Instant now) -> PlanWork {
    const auto origin = origin_at(now);
    blocks::PlanningScene scene = given;
    scene.arm = limited_arm_.get();
    scene.speed_share = speed_.share();
    if (origin) scene.start = origin->start;
    if (!origin || !origin->start.joints) scene.why_unknown = whyStartUnknown();
    scene.give_up = [dropped] { return dropped->load(); };
    scene.tables = tables_.forPlans();
    return [=, arm = limited_arm_, base = baseAt(origin)]() -> PlanAnswer {
      return planGoal(goal, scene, base, origin);
    };
  };
}

std::optional<arm::Pose> Forecast::baseAt(const std::optional<Origin>& origin) const {
  return origin ? origin->start.base : frames().base;
}

// --- What went out, and what became of it.

void Forecast::sent(const CommandOrder& order, Instant now) {
  if (order.moves && order.tag) queue_.forget();
  if (order.moves && !order.tag) queue_.queue(order.plan, now);
  tellPath(order);
}

void Forecast::accepted(const CommandOrder& order, Instant now) {
  if (order.commands) {
    const bool behind_motion = loose_.mayMove() || order.moves;
    for (const auto& command : *order.commands) {
      frames_.accepted(command, behind_motion, now);
      takeBurden(command, behind_motion);
    }
  } else {
    queue_.forget();
    frames_.forget();
    burden_.forget();
  }
  if (order.moves && !order.tag) loose_.begin(order.target, endOf(order), now);
}

void Forecast::arrived(const CommandOrder& order, Instant now) {
  queue_.arrive(order.plan, limited_arm_.get(), now);
  loose_.end();  // tags complete in the order of the queue
  if (!order.stands_at_end) loose_.begin(std::nullopt, endOf(order), now);
}

void Forecast::robotChanged(Duration patience, Instant now) {
  frames_.robotChanged(robot_, now);
  weigh();
  loose_.see(robot_, now);
  queue_.see(robot_, patience, now);
}

void Forecast::stopped() {
  loose_.end();
  queue_.forget();
  queueMayBeEmptied();
}

void Forecast::stopFailed(const std::string& found, const std::optional<robot::Target>& target, Instant now) {
  queue_.forget();
  loose_.stopFailed(found, target, now);
}

/// What waited behind a motion in the controller will not come.
void Forecast::queueMayBeEmptied() {
  frames_.stopped();
  burden_.stopped();
  weigh();
}

void Forecast::disconnected() {
  loose_.end();  // whether it moves on is for the next connection to find (orphan_watch.h)
  queue_.forget();
  frames_.forget();
  burden_.forget();
}

/// A controller may take a tool that the arm cannot carry, and fail in the first motion (FB section 5).
void Forecast::takeBurden(const script::ScriptCommand& command, bool behind_motion) {
  if (!burden_.accepted(command, behind_motion)) return;
  weigh();
  if (!robot_.tooMuch()) return;
  actions_.emplace_back(
      LogMessage{Severity::Warning,
                 robot_.tooMuch()->text + ": motions will fail; check weight of change_tcp and change_load"});
}

void Forecast::weigh() {
  if (arm_) robot_.carries(burden_.tooMuchFor(*arm_, frames()));
}

void Forecast::tellPath(const CommandOrder& order) {
  if (order.is_previewed || order.tool_path.empty()) return;
  actions_.emplace_back(PathPlanned{order.goal, order.tool_path});
}

}  // namespace cobot_command::command
