#include "preflight.h"

#include <algorithm>

#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::blocks {
namespace {

int idOf(motion::Refusal::Reason reason) {
  using Reason = motion::Refusal::Reason;
  switch (reason) {
    case Reason::NotFinite:
      return own_error::kNotFinite;
    case Reason::Unreachable:
      return own_error::kUnreachable;
    case Reason::PoseBits:
      return own_error::kPoseBits;
    case Reason::JointLimit:
      return own_error::kJointLimit;
    case Reason::JointSpeed:
      return own_error::kJointSpeed;
    case Reason::Singular:
      return own_error::kSingular;
    case Reason::BadParameter:
    case Reason::DegenerateCircle:
      break;
  }
  return own_error::kNotPlannable;
}

}  // namespace

bool Preflight::isQueued(const RobotWatch& robot, Instant now) const {
  if (!queue_end_) return false;
  const bool seen_since = robot.status() && robot.status()->received > queue_end_->time;
  return now < queue_end_->time || !seen_since || robot.moving().value_or(false) || robot.held();
}

Result<std::optional<Plan>, Failure> Preflight::plan(const motion::Command& command, const RobotWatch& robot,
                                                     Instant now) const {
  if (!arm_) return std::optional<Plan>();
  const bool queued = isQueued(robot, now);
  const bool moves_to_unknown_place = !queued && robot.moving().value_or(false);
  const auto joints = queued ? std::optional<arm::JointVector>(queue_end_->joints) : robot.joints();
  if (!joints || moves_to_unknown_place) return std::optional<Plan>();

  const motion::Setting setting{robot.base(), robot.tcp(), robot.speedOverride()};
  const auto trajectory = motion::plan(*arm_, *joints, command, setting);
  if (!trajectory) return refuse(Failure{idOf(trajectory.error().reason), trajectory.error().message, ""});

  Plan plan;
  plan.duration = (*trajectory)->duration();
  if (queued) plan.start_delay = std::max(Duration::zero(), queue_end_->time - now);
  plan.end = (*trajectory)->end().position;
  return std::optional<Plan>(plan);
}

void Preflight::queue(const std::optional<Plan>& plan, Instant now) {
  queue_end_.reset();
  if (plan) queue_end_ = QueueEnd{plan->end, now + plan->start_delay + plan->duration};
}

void Preflight::arrive(const std::optional<Plan>& plan, Instant now) {
  queue_end_.reset();
  if (plan) queue_end_ = QueueEnd{plan->end, now};
}

}  // namespace cobot_command::blocks
