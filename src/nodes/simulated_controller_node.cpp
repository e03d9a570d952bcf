// The simulated controller as a ROS node. Exit status: 0 at the end, 1 when a port cannot be had, 2 when a
// parameter or an argument cannot be used.
#include "cobot_command/ros/simulation/simulated_controller_node.h"

#include "node_arguments.h"
#include <ros/ros.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/node_end.h"

namespace {

using cobot_command::runtime::SimulatorError;
namespace ros_adapter = cobot_command::ros_adapter;

const cobot_command::nodes::NodeDescription kNode{
    "simulated_controller_node", "A simulated TM controller with its arm and services for the operator.",
    "_script_port:=5890"};

int serve(int argc, char** argv) {
  ros_adapter::NodeEnd end(argc, argv, "simulated_controller");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  if (!end.joined()) return 0;
  auto parameters = ros_adapter::readSimulatorParameters(node, self);
  if (end.isAskedFor()) return 0;  // whatever was read by then
  if (!parameters) {
    ROS_FATAL_STREAM(cobot_command::forPeople(parameters.error().message));
    return 2;
  }
  ros_adapter::SimulatedControllerNode controller(self, std::move(*parameters));
  if (const auto started = controller.start(); !started) {
    ROS_FATAL_STREAM(cobot_command::forPeople(started.error().message));
    return started.error().kind == SimulatorError::Kind::BadOption ? 2 : 1;
  }
  end.serve([](const auto& begun) { begun(); });
  end.leaveWithin(ros_adapter::kFarewellPatience);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return cobot_command::nodes::runNode(argc, argv, kNode, [&] { return serve(argc, argv); });
}
