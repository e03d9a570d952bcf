// The ROS node of a mechanism in a cell: a turntable, a pallet, a track. Exit status: 0 at the end, 2 when a
// parameter or an argument cannot be used.
#include <memory>

#include "node_arguments.h"
#include <ros/ros.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/mechanism/mechanism_node.h"
#include "cobot_command/ros/shared/node_end.h"

namespace {

namespace ros_adapter = cobot_command::ros_adapter;

const cobot_command::nodes::NodeDescription kNode{
    "cell_mechanism",
    "Asks the cell supervisor for permission to move a mechanism, and reports its position.",
    "_artifact:=/home/me/pallet.artifact _mechanism:=PALLET"};

int serve(int argc, char** argv) {
  ros_adapter::NodeEnd end(argc, argv, "cell_mechanism");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  if (!end.joined()) return 0;
  const auto parameters = ros_adapter::readMechanismParameters(ros_adapter::givenParameters(node, self));
  if (end.isAskedFor()) return 0;  // whatever was read by then
  if (!parameters) {
    ROS_FATAL_STREAM(cobot_command::forPeople(parameters.error().message));
    return 2;
  }
  for (const std::string& warning : parameters->warnings) ROS_WARN_STREAM(cobot_command::forPeople(warning));
  const auto mechanism = ros_adapter::MechanismNode::of(node, *parameters);
  if (!mechanism) {
    ROS_FATAL_STREAM("~artifact, ~mechanism: " << cobot_command::forPeople(mechanism.error()));
    return 2;
  }
  end.serve([](const auto& begun) { begun(); });
  end.leaveWithin(ros_adapter::kFarewellPatience);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return cobot_command::nodes::runNode(argc, argv, kNode, [&] { return serve(argc, argv); });
}
