#include "forecast/preflight.h"

#include <algorithm>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::command {
namespace {

/// A motion that is no longer than this in any joint ends next to where it began.
constexpr double kNextTo = degToRad(0.5);  // [rad]

}  // namespace

bool Preflight::isQueued(const robot::RobotWatch& robot, Instant now) const {
  if (!queue_) return false;
  const bool seen_since = robot.status() && robot.status()->received > queue_->end();
  return now < queue_->end() || !seen_since || robot.moving().value_or(false) || robot.held();
}

Origin Preflight::origin(const robot::RobotWatch& robot, const robot::FrameWatch& frames,
                         const robot::LooseMotion& loose, Instant now) const {
  const bool queued = isQueued(robot, now);
  // The stream shows a motion a little after its acceptance.
  const bool moves_to_unknown_place = !queued && (robot.moving().value_or(false) || loose.endsUnknown());
  Origin origin;
  if (queued) {
    origin.start.joints = queue_->planner.joints();
  } else if (!moves_to_unknown_place) {
    origin.start.joints = robot.joints();
  }
  // Unknown are only frames of a name whose value the stream has not told yet. Where it tells nothing at all,
  // robot base and flange are what a project starts with.
  const robot::ActiveFrames active = frames.frames();
  origin.start.base = active.base;
  if (!active.base && active.base_name.empty()) origin.start.base = arm::Pose::Identity();
  origin.start.tcp = active.tcp;
  if (!active.tcp && active.tcp_name.empty()) origin.start.tcp = arm::Pose::Identity();
  origin.frames_told = active.base && active.tcp;
  origin.start.speed_override = robot.speedOverride();
  if (queued) {
    origin.behind = queue_->planner;
    origin.behind->follow(origin.start);
    origin.arrival = now - queue_->began;
  }
  return origin;
}

Result<std::optional<Plan>, blocks::Failure> Preflight::plan(
    const std::vector<script::ScriptCommand>& commands, const Origin& origin) const {
  return arm_ ? planFor(*arm_, commands, origin) : std::optional<Plan>();
}

Result<std::optional<Plan>, blocks::Failure> Preflight::planFor(
    const arm::ArmModel& arm, const std::vector<script::ScriptCommand>& commands, const Origin& origin) {
  planning::ScriptPlanner planner = origin.behind.value_or(planning::ScriptPlanner(arm, origin.start));
  Plan plan;
  plan.tcp = origin.start.tcp.value_or(arm::Pose::Identity());
  plan.arrival = origin.arrival;
  std::optional<Duration> begin;
  for (const script::ScriptCommand& command : commands) {
    const auto step = planner.append(command, origin.arrival);
    if (!step) return refuse(blocks::toFailure(step.error()));
    if (!step->planned) return std::optional<Plan>();
    if (!step->trajectory) continue;
    if (!begin) begin = step->start;
    plan.motions.push_back(step->trajectory);
  }
  if (begin) {
    plan.start_delay = std::max(Duration::zero(), *begin - origin.arrival);
    plan.duration = planner.duration() - *begin;
  }
  plan.end = {planner.end(), planner, Duration::zero(), origin.frames_told};
  plan.target = targetOf(commands, plan);
  return std::optional<Plan>(std::move(plan));
}

std::optional<robot::Target> Preflight::targetOf(const std::vector<script::ScriptCommand>& commands,
                                                 const Plan& plan) {
  const auto kind = robot::targetKindOf(commands);
  const auto& end = plan.end.start;
  if (!kind || plan.motions.empty() || !end.joints) return std::nullopt;
  if (*kind != robot::TargetKind::Joints && !(plan.end.frames_told && end.tcp)) return std::nullopt;
  const arm::JointVector begin = plan.motions.front()->at(Duration::zero()).position;
  const double way = (*end.joints - begin).cwiseAbs().maxCoeff();
  return robot::Target{*kind, *end.joints, end.tcp.value_or(arm::Pose::Identity()), way <= kNextTo};
}

Result<std::optional<Plan>, blocks::Failure> planOfCommand(const blocks::Command& command,
                                                           const arm::ArmModel* arm,
                                                           const std::optional<arm::Pose>& base,
                                                           const std::optional<Origin>& origin) {
  if (command.traits.needs_base && !base) {
    return refuse(blocks::Failure{blocks::own_error::kBaseUnknown, "", ""});
  }
  const blocks::Order order = command.order(base.value_or(arm::Pose::Identity()));
  if (!origin || !order.commands || arm == nullptr) return std::optional<Plan>();
  return Preflight::planFor(*arm, *order.commands, *origin);
}

void Preflight::see(const robot::RobotWatch& robot, Duration patience, Instant now) {
  if (!queue_) return;
  queue_->stall.see(robot, now);
  if (robot.inError() || robot.emergencyStop() || queue_->stall.stalled(patience)) forget();
}

void Preflight::queue(const std::optional<Plan>& plan, Instant now) {
  queue_.reset();
  if (plan && plan->end.start.joints) queue_ = Queue{*plan->end.behind, now - plan->arrival};
}

void Preflight::arrive(const std::optional<Plan>& plan, Instant now) {
  queue_.reset();
  if (plan && plan->end.start.joints) queue_ = Queue{{*arm_, plan->end.start}, now};
}

}  // namespace cobot_command::command
