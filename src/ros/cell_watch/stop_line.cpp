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

void tell(const std::string& robot, const cobot_command::StopResult& result) {
  if (result.error_id == 0) {
    ROS_INFO_STREAM(forPeople(robot) << " is at standstill, or no longer accepts commands that move it");
  } else {
    ROS_ERROR_STREAM(forPeople(robot) << " may still move: " << foreignText(result.error_description) << " "
                                      << foreignText(result.remedy));
  }
}

}  // namespace

StopLine::StopLine(const ros::NodeHandle& node, std::shared_ptr<ros::CallbackQueueInterface> queue,
                   std::string robot, const std::string& space)
    : node_(node), queue_(std::move(queue)), robot_(std::move(robot)), id_(anyId(robot_)), goals_(node) {
  goals_.beginAt(space);
  results_.set(listeningIn(space)());
  node_.requireType(space + "/stop/goal", "cobot_command/StopActionGoal");
}

void StopLine::moveTo(const std::string& space) {
  goals_.moveTo(space);
  results_.begin(listeningIn(space));
}

MadeBeside<ros::Subscriber>::Make StopLine::listeningIn(const std::string& space) const {
  const boost::function<void(const cobot_command::StopActionResultConstPtr&)> take =
      [robot = robot_, id = id_](const cobot_command::StopActionResultConstPtr& message) {
        if (message->status.goal_id.id.rfind(id, 0) != 0) return;  // somebody else's
        tell(robot, message->result);
      };
  return [node = node_, queue = queue_, topic = space + "/stop/result", take]() mutable {
    return std::make_shared<ros::Subscriber>(node.subscribe<cobot_command::StopActionResult>(
        topic, kQueueSize, take, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  };
}

void StopLine::stop() {
  goals_.send(fmt::format("{}-{}", id_, ++sent_));
  if (isConnected()) return;
  ROS_ERROR_STREAM(forPeople(robot_) << " cannot be stopped: no node subscribes to " << goals_.topic()
                                     << ". Make sure that it is at standstill.");
}

}  // namespace cobot_command::ros_adapter
