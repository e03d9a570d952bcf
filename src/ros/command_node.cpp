#include "cobot_command/ros/command_node.h"

#include <utility>

#include <ros/console.h>

#include "cobot_command/ConnectAction.h"
#include "cobot_command/MoveAbsoluteAction.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::ros_adapter {
namespace {

void log(const blocks::LogMessage& message) {
  switch (message.severity) {
    case blocks::Severity::Info:
      ROS_INFO_STREAM_NAMED("link", message.text);
      break;
    case blocks::Severity::Warning:
      ROS_WARN_STREAM_NAMED("link", message.text);
      break;
    case blocks::Severity::Error:
      ROS_ERROR_STREAM_NAMED("link", message.text);
      break;
  }
}

}  // namespace

CommandNode::CommandNode(const ros::NodeHandle& node, CommandParameters parameters)
    : default_host_(parameters.robot_ip),
      default_port_(parameters.script_port),
      publisher_(node, jointNames(parameters.prefix), parameters.prefix) {
  if (!parameters.arm)
    ROS_WARN("no robot model: moves are sent to the controller without planning them first");
  // The core exists before the first goal can come in, and its thread says nothing until it gets one.
  runtime_ = std::make_unique<runtime::CommandRuntime>(
      std::move(parameters.arm), parameters.link,
      [this](const blocks::Action& action, Instant now) { onAction(action, now); });
  serve<cobot_command::ConnectAction>(node, "connect");
  serve<cobot_command::MoveAbsoluteAction>(node, "move_absolute");
}

CommandNode::~CommandNode() {
  runtime_->stop();
}

template <class ActionType>
void CommandNode::serve(const ros::NodeHandle& node, const char* name) {
  GoalSink sink;
  sink.new_id = [this] { return ++last_goal_; };
  sink.submit = [this](blocks::GoalId id, const blocks::Goal& goal) { submit(id, goal); };
  sink.cancel = [this](blocks::GoalId id) { runtime_->cancel(id); };
  bridges_.push_back(std::make_unique<ActionBridge<ActionType>>(node, name, std::move(sink)));
}

void CommandNode::submit(blocks::GoalId id, blocks::Goal goal) {
  if (auto* connect = std::get_if<blocks::ConnectGoal>(&goal)) {
    if (connect->host.empty()) connect->host = default_host_;
    if (connect->port == 0) connect->port = default_port_;
  }
  // Refused only once the node is being destroyed, when nobody hears an answer any more.
  static_cast<void>(runtime_->submit(id, std::move(goal)));
}

void CommandNode::onAction(const blocks::Action& action, Instant now) {
  const ClockPair clocks{ros::Time::now(), now};
  std::visit(Overloaded{
                 [&](const blocks::GoalAccepted& a) {
                   for (const auto& bridge : bridges_) bridge->accepted(a.goal);
                 },
                 [&](const blocks::GoalProgressed& a) {
                   for (const auto& bridge : bridges_) bridge->progressed(a.goal, a.progress);
                 },
                 [&](const blocks::GoalEnded& a) {
                   for (const auto& bridge : bridges_) bridge->ended(a.goal, a.outcome);
                 },
                 [&](const blocks::RobotStatusReceived& a) { publisher_.publish(a.status); },
                 [&](const blocks::StatusChanged& a) { publisher_.publish(a.status, clocks); },
                 [&](const blocks::FrameTraced& a) { publisher_.publish(a, clocks); },
                 [&](const blocks::LogMessage& a) { log(a); },
                 [](const auto&) {},  // connections and bytes are the runtime's own business
             },
             action);
}

}  // namespace cobot_command::ros_adapter
