#include "cell_watch/stop_line.h"

#include <random>
#include <utility>

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/this_node.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 5;

/// A goal of a monitor before this one is no goal of this one.
std::string anyId(const std::string& robot) {
  std::random_device random;
  return fmt::format("{}-{:08x}-{}", ros::this_node::getName(), random(), robot);
}

}  // namespace

StopLine::StopLine(const ros::NodeHandle& node, std::string robot, const std::string& space)
    : node_(node), robot_(std::move(robot)), id_(anyId(robot_)), goals_(node) {
  moveTo(space);
  node_.requireType(space + "/stop/goal", "cobot_command/StopActionGoal");
}

void StopLine::moveTo(const std::string& space) {
  goals_.moveTo(space);
  const boost::function<void(const cobot_command::StopActionResultConstPtr&)> take =
      [this](const cobot_command::StopActionResultConstPtr& message) { hear(*message); };
  results_ = node_.subscribe<cobot_command::StopActionResult>(
      space + "/stop/result", kQueueSize, take, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

void StopLine::stop() {
  goals_.send(fmt::format("{}-{}", id_, ++sent_));
  if (isConnected()) return;
  ROS_ERROR_STREAM(forPeople(robot_) << " cannot be told to stop: nobody listens to " << goals_.topic()
                                     << ". Make sure that it stands.");
}

void StopLine::hear(const cobot_command::StopActionResult& message) const {
  if (message.status.goal_id.id.rfind(id_, 0) != 0) return;  // somebody else's
  if (message.result.error_id == 0) {
    ROS_INFO_STREAM(forPeople(robot_) << " stands, or takes nothing any more that moves it");
  } else {
    ROS_ERROR_STREAM(robot_ << " may still move: " << foreignText(message.result.error_description) << " "
                            << foreignText(message.result.remedy));
  }
}

}  // namespace cobot_command::ros_adapter
