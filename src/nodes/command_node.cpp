// The ROS node that commands one robot. Exit status: 0 at the end, 2 when a parameter cannot be used.
#include "cobot_command/ros/command_node.h"

#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "command_node");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  auto parameters = cobot_command::ros_adapter::readCommandParameters(node, self);
  if (!parameters) {
    ROS_FATAL_STREAM(parameters.error().message);
    return 2;
  }
  const cobot_command::ros_adapter::CommandNode command_node(node, self, std::move(*parameters));
  ros::spin();
  return 0;
}
