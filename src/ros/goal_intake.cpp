#include "cobot_command/ros/goal_intake.h"

#include <algorithm>
#include <utility>

namespace cobot_command::ros_adapter {

GoalIntake::GoalIntake(FrameLookup frames, FramePatience patience, Core core)
    : frames_(std::move(frames)), patience_(std::move(patience)), core_(std::move(core)) {}

void GoalIntake::submit(blocks::GoalId id, GoalReader read, Instant now) {
  Reading reading = readNow(read);
  // A stop takes away what came before it: it must not overtake that, and cannot wait for it.
  if (std::holds_alternative<blocks::StopGoal>(reading.goal)) flush();
  const bool never_waits = std::holds_alternative<blocks::ProgramControlGoal>(reading.goal);
  if (never_waits || (reading.complete && waiting_.empty())) {
    core_.submit(id, std::move(reading.goal));
  } else {
    waiting_.push_back({id, std::move(read), now + patience_()});
  }
}

void GoalIntake::cancel(blocks::GoalId id) {
  if (std::any_of(waiting_.begin(), waiting_.end(), [id](const Waiting& w) { return w.id == id; })) flush();
  core_.cancel(id);
}

void GoalIntake::advance(Instant now) {
  while (!waiting_.empty()) {
    Reading reading = readNow(waiting_.front().read);
    if (!reading.complete && now < waiting_.front().deadline) return;
    const blocks::GoalId id = waiting_.front().id;
    waiting_.pop_front();
    core_.submit(id, std::move(reading.goal));
  }
}

GoalIntake::Reading GoalIntake::readNow(const GoalReader& read) const {
  bool complete = true;
  blocks::Goal goal = read([&](const std_msgs::Header& header) {
    FramePlace place = frames_(header);
    complete = complete && place.in_robot_base.has_value();
    return place;
  });
  return {std::move(goal), complete};
}

void GoalIntake::flush() {
  advance(Instant::max());
}

}  // namespace cobot_command::ros_adapter
