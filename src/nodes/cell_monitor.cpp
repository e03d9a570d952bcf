// The ROS node that watches the robots of a cell. Exit status: 0 at the end, 2 when a parameter, an argument
// or a file that one names cannot be used.
#include "node_arguments.h"
#include <ros/ros.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/cell_watch/monitor_node.h"
#include "cobot_command/ros/shared/node_end.h"

namespace {

namespace ros_adapter = cobot_command::ros_adapter;

const cobot_command::nodes::NodeDescription kNode{
    "cell_monitor", "Stops the robots of a cell when two of them come too close. No safety function.",
    "_cell_file:=/home/me/cell.yaml"};

int serve(int argc, char** argv) {
  ros_adapter::NodeEnd end(argc, argv, "cell_monitor");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  if (!end.joined()) return 0;
  const auto parameters = ros_adapter::readMonitorParameters(node, self);
  if (end.isAskedFor()) return 0;  // whatever was read by then
  if (!parameters) {
    ROS_FATAL_STREAM(cobot_command::forPeople(parameters.error().message));
    return 2;
  }
  const auto monitor = ros_adapter::MonitorNode::of(node, self, *parameters);
  if (!monitor) {
    for (const std::string& fault : monitor.error()) ROS_FATAL_STREAM(cobot_command::forPeople(fault));
    return 2;
  }
  end.serve([](const auto& begun) { begun(); });
  (*monitor)->stop();
  end.leaveWithin(ros_adapter::kFarewellPatience);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return cobot_command::nodes::runNode(argc, argv, kNode, [&] { return serve(argc, argv); });
}
