#include "robot_data/robot_data_publisher.h"

#include <utility>

#include "robot_data/robot_data_message.h"

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

RobotDataPublisher::RobotDataPublisher(const ros::NodeHandle& node, JointNames joint_names, Arm arm)
    : joint_names_(std::move(joint_names)), arm_(std::move(arm)) {
  topic_ = OwnHandle(node).advertise<cobot_command::RobotData>("robot_data", 1, true);
  publish();
}

void RobotDataPublisher::take(const link::RobotStatus& status) {
  if (status.identity == identity_) return;
  identity_ = status.identity;
  publish();
}

void RobotDataPublisher::publish() {
  topic_.publish(toMessage(arm_().get(), joint_names_, identity_, ros::Time::now()));
}

}  // namespace cobot_command::ros_adapter
