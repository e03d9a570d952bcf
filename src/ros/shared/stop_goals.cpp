#include "shared/stop_goals.h"

#include <ros/names.h>

#include "cobot_command/StopActionGoal.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 10;

std::string topicIn(const std::string& space) {
  return ros::names::append(space, "stop/goal");
}

std::shared_ptr<ros::Publisher> publisherOn(ros::NodeHandle node, const std::string& topic) {
  return std::make_shared<ros::Publisher>(node.advertise<cobot_command::StopActionGoal>(topic, kQueueSize));
}

}  // namespace

void StopGoals::beginAt(const std::string& space) {
  topic_ = topicIn(space);
  goals_[topic_].set(publisherOn(node_, topic_));
}

void StopGoals::moveTo(const std::string& space) {
  topic_ = topicIn(space);
  MadeBeside<ros::Publisher>& goals = goals_[topic_];
  if (!goals.get()) goals.begin([node = node_, topic = topic_] { return publisherOn(node, topic); });
}

std::shared_ptr<ros::Publisher> StopGoals::goals() const {
  const auto found = goals_.find(topic_);
  return found == goals_.end() ? nullptr : found->second.get();
}

bool StopGoals::isConnected() const {
  const auto goals = this->goals();
  return goals && *goals && goals->getNumSubscribers() > 0;
}

void StopGoals::send(const std::string& id) {
  const auto goals = this->goals();
  if (!goals || !*goals) return;
  cobot_command::StopActionGoal goal;
  goal.header.stamp = ros::Time::now();
  // Without a stamp: a cancel of all goals before some time, of another clock, would recall it.
  goal.goal_id.id = id;
  goals->publish(goal);
}

}  // namespace cobot_command::ros_adapter
