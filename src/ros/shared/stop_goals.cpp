#include "shared/stop_goals.h"

#include <ros/names.h>

#include "cobot_command/StopActionGoal.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 10;

}  // namespace

void StopGoals::moveTo(const std::string& space) {
  goals_ = node_.advertise<cobot_command::StopActionGoal>(ros::names::append(space, "stop/goal"), kQueueSize);
}

void StopGoals::send(const std::string& id) {
  if (!goals_) return;
  cobot_command::StopActionGoal goal;
  goal.header.stamp = ros::Time::now();
  // Without a stamp: a cancel of all goals before some time, of another clock, would recall it.
  goal.goal_id.id = id;
  goals_.publish(goal);
}

}  // namespace cobot_command::ros_adapter
