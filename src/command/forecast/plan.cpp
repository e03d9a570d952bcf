#include "forecast/plan.h"

#include <algorithm>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"
#include "cobot_command/common/units.h"
#include "cobot_command/planning/sampling.h"

namespace cobot_command::command {
namespace {

/// A motion that is no longer than this in any joint ends next to where it began.
constexpr double kNextTo = degToRad(0.5);  // [rad]
/// A robot that stands is streamed within this of where it was.
constexpr double kSamePlace = degToRad(0.1);  // [rad]
/// One that blends into a motion under way is sent so much later than it was planned for, at least.
constexpr Duration kSameMoment = std::chrono::milliseconds(20);
/// Of one motion, for a marker.
constexpr std::size_t kPathPoints = 60;

std::optional<robot::Target> targetOf(const std::vector<script::ScriptCommand>& commands, const Plan& plan) {
  const auto kind = robot::targetKindOf(commands);
  const auto& end = plan.end.start;
  if (!kind || plan.motions.empty() || !end.joints) return std::nullopt;
  if (*kind != robot::TargetKind::Joints && !(plan.end.frames_told && end.tcp)) return std::nullopt;
  const arm::JointVector begin = plan.motions.front()->at(Duration::zero()).position;
  const double way = (*end.joints - begin).cwiseAbs().maxCoeff();
  return robot::Target{*kind, *end.joints, end.tcp.value_or(arm::Pose::Identity()), way <= kNextTo};
}

bool isSame(const std::optional<arm::Pose>& a, const std::optional<arm::Pose>& b) {
  return a && b ? arm::isSamePose(*a, *b) : !a && !b;
}

bool isSamePlace(const std::optional<arm::JointVector>& a, const std::optional<arm::JointVector>& b) {
  return a && b ? (*a - *b).cwiseAbs().maxCoeff() <= kSamePlace : !a && !b;
}

bool isBehindTheSame(const Origin& then, const Origin& now) {
  if (!then.isBehindMotion() || !now.isBehindMotion()) return !then.isBehindMotion() && !now.isBehindMotion();
  return then.behind->duration() == now.behind->duration();
}

bool isSameStart(const Origin& then, const Origin& now) {
  return isSamePlace(then.start.joints, now.start.joints) && isSame(then.start.base, now.start.base) &&
         isSame(then.start.tcp, now.start.tcp) && then.start.speed_override == now.start.speed_override &&
         then.frames_told == now.frames_told && isBehindTheSame(then, now);
}

/// The robot has gone past the place where it was to blend into the next motion.
bool isPastItsBlend(const PlannedCommand& planned, const Origin& now) {
  if (!now.isBehindMotion() || !planned.plan || !*planned.plan) return false;
  return now.arrival - planned.origin.arrival > std::max((*planned.plan)->start_delay, kSameMoment);
}

}  // namespace

bool isStillGood(const PlannedCommand& planned, const Origin& now) {
  return isSameStart(planned.origin, now) && !isPastItsBlend(planned, now);
}

Planned planFor(const arm::ArmModel* arm, const std::vector<script::ScriptCommand>& commands,
                const Origin& origin, const blocks::GiveUp& give_up) {
  if (arm == nullptr) return std::optional<Plan>();
  planning::ScriptPlanner planner = origin.behind.value_or(planning::ScriptPlanner(*arm, origin.start));
  Plan plan;
  plan.tcp = origin.start.tcp.value_or(arm::Pose::Identity());
  plan.arrival = origin.arrival;
  std::optional<Duration> begin;
  for (const script::ScriptCommand& command : commands) {
    if (give_up && give_up()) return std::optional<Plan>();
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

Result<blocks::Order, blocks::Failure> linesOf(const blocks::Command& command,
                                               const std::optional<arm::Pose>& base, double speed_share) {
  if (command.traits.needs_base && !base) {
    return refuse(blocks::Failure{blocks::own_error::kBaseUnknown, "", ""});
  }
  return slowed(command.order(base.value_or(arm::Pose::Identity())), speed_share);
}

Planned planFor(const arm::ArmModel* arm, const blocks::Command& command,
                const std::optional<arm::Pose>& base, double speed_share, const std::optional<Origin>& origin,
                const blocks::GiveUp& give_up) {
  const auto order = linesOf(command, base, speed_share);
  if (!order) return refuse(order.error());
  if (!origin || !order->commands) return std::optional<Plan>();
  return planFor(arm, *order->commands, *origin, give_up);
}

std::vector<arm::Pose> toolPathOf(const Plan& plan, const arm::ArmModel& arm) {
  std::vector<arm::Pose> path;
  for (const auto& motion : plan.motions) {
    const auto poses = planning::toolPath(arm, *motion, plan.tcp, kPathPoints);
    path.insert(path.end(), poses.begin(), poses.end());
  }
  return path;
}

}  // namespace cobot_command::command
