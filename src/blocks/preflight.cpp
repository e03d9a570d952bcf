#include "preflight.h"

#include <algorithm>

#include "refusal_failure.h"

#include "cobot_command/planning/script_planner.h"

namespace cobot_command::blocks {

bool Preflight::isQueued(const RobotWatch& robot, Instant now) const {
  if (!queue_end_) return false;
  const bool seen_since = robot.status() && robot.status()->received > queue_end_->time;
  return now < queue_end_->time || !seen_since || robot.moving().value_or(false) || robot.held();
}

std::optional<Origin> Preflight::origin(const RobotWatch& robot, const FrameWatch& frames,
                                        Instant now) const {
  const bool queued = isQueued(robot, now);
  const bool moves_to_unknown_place = !queued && robot.moving().value_or(false);
  const auto joints = queued ? std::optional<arm::JointVector>(queue_end_->joints) : robot.joints();
  if (!joints || moves_to_unknown_place) return std::nullopt;

  const ActiveFrames active = frames.frames();
  // A name of the project whose value the stream has not told yet.
  const bool unknown_base = !active.base && !active.base_name.empty();
  const bool unknown_tcp = !active.tcp && !active.tcp_name.empty();
  if (unknown_base || unknown_tcp) return std::nullopt;

  Origin origin;
  origin.joints = *joints;
  origin.setting.base = active.base.value_or(arm::Pose::Identity());
  origin.setting.tcp = active.tcp.value_or(arm::Pose::Identity());
  origin.setting.speed_override = robot.speedOverride();
  if (queued) origin.delay = std::max(Duration::zero(), queue_end_->time - now);
  return origin;
}

Result<std::optional<Plan>, Failure> Preflight::plan(const std::vector<protocol::ScriptCommand>& commands,
                                                     const std::optional<Origin>& origin) const {
  if (!arm_ || !origin) return std::optional<Plan>();
  planning::ScriptPlanner planner(*arm_, origin->joints, origin->setting);
  Plan plan;
  plan.start_setting = origin->setting;
  plan.start_delay = origin->delay;
  for (const protocol::ScriptCommand& command : commands) {
    const auto step = planner.append(command);
    if (!step) return refuse(toFailure(step.error()));
    if (!step->planned) return std::optional<Plan>();
    if (step->trajectory) plan.motions.push_back(step->trajectory);
  }
  plan.duration = planner.duration();
  plan.end = Origin{planner.joints(), planner.setting(), Duration::zero()};
  return std::optional<Plan>(std::move(plan));
}

void Preflight::queue(const std::optional<Plan>& plan, Instant now) {
  queue_end_.reset();
  if (plan) queue_end_ = QueueEnd{plan->end.joints, now + plan->start_delay + plan->duration};
}

void Preflight::arrive(const std::optional<Plan>& plan, Instant now) {
  queue_end_.reset();
  if (plan) queue_end_ = QueueEnd{plan->end.joints, now};
}

}  // namespace cobot_command::blocks
