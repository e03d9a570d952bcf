// The ROS node that commands one robot. Exit status: 0 at the end, 2 when a parameter
// or an argument cannot be used.
#include "cobot_command/ros/command/command_node.h"

#include "node_arguments.h"
#include <ros/ros.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/cell/cell_seat.h"
#include "cobot_command/ros/shared/node_end.h"

namespace {

namespace ros_adapter = cobot_command::ros_adapter;

const cobot_command::nodes::NodeDescription kNode{
    "command_node", "Commands one Omron/Techman TM cobot, by goals of its actions.",
    "_robot_ip:=192.168.1.10"};

int serve(int argc, char** argv) {
  ros_adapter::NodeEnd end(argc, argv, "command_node");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  if (!end.joined()) return 0;
  auto parameters = ros_adapter::readCommandParameters(node, self, [&] { return end.isAskedFor(); });
  if (end.isAskedFor()) return 0;  // whatever was read by then
  if (!parameters) {
    ROS_FATAL_STREAM(cobot_command::forPeople(parameters.error().message));
    return 2;
  }
  std::unique_ptr<ros_adapter::CellSeat> seat;
  if (!parameters->cell.cell.empty()) {
    auto taken = ros_adapter::CellSeat::of(parameters->cell, parameters->robot_model);
    if (!taken) {
      ROS_FATAL_STREAM("~cell_artifact, ~cell_robot: " << cobot_command::forPeople(taken.error()));
      return 2;
    }
    seat = std::move(*taken);
  }
  ros_adapter::CommandNode command_node(node, self, std::move(*parameters), std::move(seat));
  end.serve([&](const auto& begun) { command_node.retire(begun); });
  command_node.stop();
  end.leaveWithin(ros_adapter::kFarewellPatience);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return cobot_command::nodes::runNode(argc, argv, kNode, [&] { return serve(argc, argv); });
}
