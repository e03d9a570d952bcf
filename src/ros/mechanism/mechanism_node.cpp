#include "cobot_command/ros/mechanism/mechanism_node.h"

#include <cmath>
#include <utility>

#include "cell/cell_messages.h"
#include "shared/steady_now.h"
#include <boost/function.hpp>
#include <ros/console.h>

#include "cobot_command/StopActionGoal.h"
#include "cobot_command/ros/shared/own_handle.h"
#include "cobot_command/runtime/cell/any_id.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::ros_adapter {
namespace {

/// Less than that from one message to the next is noise [m or rad].
constexpr double kStandsWithin = 1e-4;

}  // namespace

Result<std::unique_ptr<MechanismNode>, std::string> MechanismNode::of(const ros::NodeHandle& node,
                                                                      const MechanismParameters& parameters) {
  auto artifact = runtime::readArtifact(parameters.artifact);
  if (!artifact) return refuse(artifact.error().front());
  const auto shared = std::make_shared<const cell::Artifact>(*std::move(artifact));
  auto agent = cell::MechanismAgent::of(shared, parameters.mechanism, runtime::anyId());
  if (!agent) return refuse(agent.error());
  return std::unique_ptr<MechanismNode>(
      new MechanismNode(node, parameters, std::move(*agent), shared->parameters.report_period));
}

MechanismNode::MechanismNode(const ros::NodeHandle& node, const MechanismParameters& parameters,
                             std::unique_ptr<cell::MechanismAgent> agent, Duration period)
    : agent_(std::move(agent)) {
  agent_->run(parameters.running);
  OwnHandle handle(node);
  reports_ = handle.advertise<cobot_command::CellReport>(parameters.cell + "/reports", 10);
  targets_ = handle.advertise<std_msgs::Float64>("target", 10, true);
  const boost::function<void(const cobot_command::CellStateConstPtr&)> hear = [this](const auto& message) {
    const Instant now = steadyNow();
    agent_->hear(toStatus(*message), message->number, now);
    tell(now);
  };
  states_ = handle.subscribe<cobot_command::CellState>(
      parameters.cell + "/state", 10, hear, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  const boost::function<void(const std_msgs::Float64ConstPtr&)> measured = [this](const auto& message) {
    const Instant now = steadyNow();
    measure(message->data, now);
    tell(now);
  };
  positions_ = handle.subscribe<std_msgs::Float64>("position", 10, measured, ros::VoidConstPtr(),
                                                   ros::TransportHints().tcpNoDelay());
  const boost::function<void(const cobot_command::StopActionGoalConstPtr&)> stop = [this](const auto&) {
    agent_->stop();
    tell(steadyNow());
  };
  stops_ = handle.subscribe<cobot_command::StopActionGoal>("stop/goal", 10, stop, ros::VoidConstPtr(),
                                                           ros::TransportHints().tcpNoDelay());
  run_ = handle.advertiseService("run", &MechanismNode::run, this);
  timer_ = handle.createSteadyTimer(ros::WallDuration(toSeconds(period)),
                                    [this](const ros::SteadyTimerEvent&) { tell(steadyNow()); });
}

void MechanismNode::measure(double position, Instant now) {
  if (!std::isfinite(position)) {
    ROS_ERROR_STREAM_THROTTLE(10, "position is " << position << ": must be a finite number, in m or rad");
    return;
  }
  const bool moves = !position_ || std::abs(position - *position_) > kStandsWithin;
  position_ = position;
  agent_->measure(position, moves, now);
}

void MechanismNode::tell(Instant now) {
  if (const auto report = agent_->takeReport(now)) reports_.publish(toMessage(*report));
  const auto target = agent_->target();
  if (!target || target == target_) return;
  target_ = target;
  std_msgs::Float64 message;
  message.data = *target;
  targets_.publish(message);
}

bool MechanismNode::run(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  agent_->run(request.data != 0);
  tell(steadyNow());
  response.success = 1;
  response.message = request.data != 0 ? "it starts its paths when the supervisor permits them"
                                       : "it starts no other path; a path that it has begun is completed";
  return true;
}

}  // namespace cobot_command::ros_adapter
