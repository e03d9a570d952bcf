#include "clients/robot.h"

#include <cmath>
#include <cstdint>

#include "clients/action_command.h"
#include <cobot_command/ProgramControlAction.h>
#include <cobot_command/StopAction.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr std::uint32_t kQueue = 10;
constexpr double kDegreesPerRadian = 180 / M_PI;
constexpr double kOld = 1;  // [s] for what comes 67 times in one

template <class Message, class Kept>
ros::Subscriber keep(ros::NodeHandle& node, const char* topic, Kept& kept) {
  return node.subscribe<Message>(topic, kQueue,
                                 [&kept](const boost::shared_ptr<const Message>& heard) { kept = *heard; });
}

cobot_command::ProgramControlGoal controlGoal(std::int32_t command) {
  cobot_command::ProgramControlGoal goal;
  goal.command = command;
  return goal;
}

}  // namespace

Robot::Robot(const std::string& name) : node_(name) {
  node_.setCallbackQueue(&queue_);
  auto stop = std::make_unique<ActionCommand<cobot_command::StopAction>>(node_, "stop", Unanswered::Kept);
  stop_.send = [&sender = *stop] { sender.send({}); };
  stop_.command = std::move(stop);
  auto control =
      std::make_unique<ActionCommand<cobot_command::ProgramControlAction>>(node_, "program_control");
  control_.send = [&sender = *control] {
    sender.send(controlGoal(cobot_command::ProgramControlGoal::PAUSE));
  };
  resume_ = [&sender = *control] { sender.send(controlGoal(cobot_command::ProgramControlGoal::RESUME)); };
  control_.command = std::move(control);

  command_status_topic_ = keep<cobot_command::CommandStatus>(node_, "command_status", command_status_);
  robot_status_topic_ = keep<cobot_command::RobotStatus>(node_, "robot_status", robot_status_);
  group_state_topic_ = keep<cobot_command::GroupState>(node_, "group_state", group_state_);
  joints_topic_ = keep<sensor_msgs::JointState>(node_, "joint_states", joints_);
  tool_topic_ = node_.subscribe<geometry_msgs::PoseStamped>(
      "tool_pose", kQueue, [this](const geometry_msgs::PoseStamped::ConstPtr& heard) {
        tool_ = *heard;
        tool_heard_ = ros::WallTime::now();
        if (tool_listener_) tool_listener_();
      });
  frames_topic_ = node_.subscribe<cobot_command::ActiveFrames>(
      "active_frames", kQueue, [this](const cobot_command::ActiveFrames::ConstPtr& heard) {
        frames_ = *heard;
        if (frames_listener_) frames_listener_();
      });
}

Robot::~Robot() = default;

std::optional<cobot_command::CommandStatus> Robot::commandStatus() const {
  if (command_status_topic_.getNumPublishers() == 0) return std::nullopt;
  return command_status_;
}

std::optional<cobot_command::RobotStatus> Robot::robotStatus() const {
  if (robot_status_topic_.getNumPublishers() == 0) return std::nullopt;
  return robot_status_;
}

std::optional<cobot_command::GroupState> Robot::groupState() const {
  if (group_state_topic_.getNumPublishers() == 0) return std::nullopt;
  return group_state_;
}

bool Robot::isReady() const {
  const auto status = commandStatus();
  return status && status->link_state == cobot_command::CommandStatus::READY;
}

Situation Robot::situation() const {
  const auto command = commandStatus();
  const auto robot = robotStatus().value_or(cobot_command::RobotStatus());
  return {command ? 1 : 0, command ? command->link_state : 0,
          robot.e_stopped, robot.in_error,
          robot.safeguard, robot.project_paused};
}

bool Robot::isStreaming() const {
  const auto status = commandStatus();
  return status && status->status_stream && (ros::WallTime::now() - tool_heard_).toSec() < kOld;
}

bool Robot::isSilent() const {
  const auto status = commandStatus();
  return status && status->status_stream && !isStreaming();
}

std::optional<std::array<double, 6>> Robot::joints() const {
  if (!isStreaming() || joints_.position.size() != 6) return std::nullopt;
  std::array<double, 6> degrees{};
  for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = joints_.position[i] * kDegreesPerRadian;
  return degrees;
}

std::optional<std::array<double, 6>> Robot::tool() const {
  const auto in_base = toolInBase();
  if (!in_base || !frames_.base_known) return std::nullopt;
  return arm::toControllerPose(ros_adapter::toPose(frames_.base).inverse() * *in_base);
}

std::optional<Eigen::Isometry3d> Robot::toolInBase() const {
  if (!isStreaming() || tool_.header.frame_id.empty()) return std::nullopt;
  return ros_adapter::toPose(tool_.pose);
}

std::string Robot::activeBaseFrame() const {
  constexpr std::string_view kBase = "base";
  const std::string& frame = frames_.header.frame_id;
  if (frame.size() < kBase.size()) return "";
  return frame.substr(0, frame.size() - kBase.size()) + "active_base";
}

void Robot::look() {
  stop_.command->look();
  control_.command->look();
}

}  // namespace cobot_command::rviz_plugin
