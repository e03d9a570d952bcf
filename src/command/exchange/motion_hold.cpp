#include "exchange/motion_hold.h"

#include <algorithm>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::command {

int motionsOf(const blocks::Goal& goal) {
  return std::visit(
      Overloaded{
          [](const blocks::MoveAbsoluteGoal&) { return 1; },
          [](const blocks::MoveRelativeGoal&) { return 1; }, [](const blocks::MoveCircleGoal&) { return 1; },
          [](const blocks::LoadPathGoal& path) { return std::max(1, static_cast<int>(path.path.size())); },
          [](const blocks::FollowJointTrajectoryGoal&) { return 1; },
          [](const auto& /*moves nothing, or more than can be counted*/) { return 0; }},
      goal);
}

void MotionHold::end() {
  delay_ = Duration::zero();
  first_.reset();
}

void MotionHold::begin(blocks::GoalId first, Instant now) {
  if (delay_ <= Duration::zero()) return;
  first_ = first;
  until_ = now + delay_;
}

bool MotionHold::holdsBack(blocks::GoalId first, int motions) {
  const bool are_all_there = motions_ > 0 && motions >= motions_;
  if (first_ != first || are_all_there) first_.reset();
  return isHolding();
}

void MotionHold::advance(Instant now) {
  if (first_ && now >= until_) first_.reset();
}

std::optional<Instant> MotionHold::nextDeadline() const {
  return first_ ? std::optional(until_) : std::nullopt;
}

}  // namespace cobot_command::command
