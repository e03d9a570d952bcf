#include "forecast/planned_queue.h"

#include <utility>

namespace cobot_command::command {

void PlannedQueue::queue(const std::optional<Plan>& plan, Instant now) {
  forget();
  if (plan && plan->end.start.joints) queued_ = Queued{*plan->end.behind, now - plan->arrival};
}

void PlannedQueue::arrive(const std::optional<Plan>& plan, const arm::ArmModel* arm, Instant now) {
  forget();
  if (plan && arm != nullptr && plan->end.start.joints) queued_ = Queued{{*arm, plan->end.start}, now};
}

void PlannedQueue::see(const robot::RobotWatch& robot, Duration patience, Instant now) {
  if (!queued_) return;
  queued_->stall.see(robot, now);
  if (robot.inError() || robot.emergencyStop() || queued_->stall.stalled(patience)) forget();
}

bool PlannedQueue::isUnderWay(const robot::RobotWatch& robot, Instant now) const {
  if (!queued_) return false;
  const bool seen_since = robot.status() && robot.status()->received > queued_->end();
  return now < queued_->end() || !seen_since || robot.moving().value_or(false) || robot.held();
}

Origin PlannedQueue::endFrom(Origin origin, Instant now) const {
  origin.start.joints = queued_->planner.joints();
  origin.behind = queued_->planner;
  origin.behind->follow(origin.start);
  origin.arrival = now - queued_->began;
  return origin;
}

}  // namespace cobot_command::command
