// The ROS node that supervises a cell of several robots. Exit status: 0 at the end, 2 when a parameter or an
// argument cannot be used.
#include <memory>
#include <utility>

#include "node_arguments.h"
#include <ros/ros.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/node_end.h"
#include "cobot_command/ros/supervision/supervisor_node.h"
#include "cobot_command/ros/supervision/supervisor_parameters.h"

namespace {

namespace ros_adapter = cobot_command::ros_adapter;

const cobot_command::nodes::NodeDescription kNode{
    "cell_supervisor", "Grants the robots of a cell permission to move, so that they do not collide.",
    "_artifact:=/home/me/handover.artifact _journal:=/home/me/handover.journal"};

int serve(int argc, char** argv) {
  ros_adapter::NodeEnd end(argc, argv, "cell_supervisor");
  const ros::NodeHandle node;
  const ros::NodeHandle self("~");
  if (!end.joined()) return 0;
  const auto parameters = ros_adapter::readSupervisorParameters(ros_adapter::givenParameters(node, self));
  if (end.isAskedFor()) return 0;  // whatever was read by then
  if (!parameters) {
    ROS_FATAL_STREAM(cobot_command::forPeople(parameters.error().message));
    return 2;
  }
  for (const std::string& warning : parameters->warnings) ROS_WARN_STREAM(cobot_command::forPeople(warning));
  // Its services would take the place of those of the first one, without a word.
  const std::string hold = node.resolveName("hold");
  if (ros::service::exists(hold, false)) {
    ROS_FATAL_STREAM("another supervisor provides "
                     << cobot_command::forPeople(hold)
                     << " already: stop it, or give this cell another namespace");
    return 2;
  }
  auto supervisor = cobot_command::runtime::CellSupervisor::open(parameters->files, parameters->policy);
  if (!supervisor) {
    ROS_FATAL_STREAM(cobot_command::forPeople(supervisor.error()));
    return 2;
  }
  const ros_adapter::SupervisorNode supervisor_node(node, self, std::move(*supervisor));
  end.serve([](const auto& begun) { begun(); });
  end.leaveWithin(ros_adapter::kFarewellPatience);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return cobot_command::nodes::runNode(argc, argv, kNode, [&] { return serve(argc, argv); });
}
