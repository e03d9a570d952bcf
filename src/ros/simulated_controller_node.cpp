#include "cobot_command/ros/simulated_controller_node.h"

#include <cstdint>
#include <future>
#include <memory>
#include <utility>

#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>

#include "cobot_command/ros/status_messages.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 100;

runtime::SimulatorOptions optionsOf(const SimulatorParameters& parameters) {
  runtime::SimulatorOptions options;
  options.bind_address = parameters.bind_address;
  options.script_port = parameters.script_port;
  options.status_port = parameters.status_port;
  options.time_scale = parameters.time_scale;
  options.state_period = fromSeconds(1.0 / parameters.publish_rate);
  return options;
}

/// The truth in the words of the status stream, so that both make the same message.
link::RobotStatus asStreamed(const simulator::RobotState& state) {
  link::RobotStatus status;
  status.joint_velocities = state.velocities;
  status.operating_mode = static_cast<int>(state.mode);
  status.emergency_stop = state.emergency_stop;
  status.safeguard = state.safeguard;
  status.error = state.error;
  status.error_code = state.error_code;
  status.error_text = state.error_text;
  status.project_running = state.project_running;
  status.project_paused = state.project_paused;
  status.project_speed_percent = state.project_speed_percent;
  status.base_name = state.base_name;
  status.tcp_name = state.tcp_name;
  return status;
}

template <class Response>
bool answer(simulator::OperatorReply reply, Response& response) {
  response.success = reply.done;
  response.message = std::move(reply.text);
  return true;
}

}  // namespace

SimulatedControllerNode::SimulatedControllerNode(const ros::NodeHandle& self, SimulatorParameters parameters)
    : self_(self),
      joint_names_(jointNames(parameters.prefix)),
      base_frame_(parameters.prefix + "base"),
      joint_states_(self_.advertise<sensor_msgs::JointState>("joint_states", kQueueSize)),
      tool_pose_(self_.advertise<geometry_msgs::PoseStamped>("tool_pose", kQueueSize)),
      status_(self_.advertise<cobot_command::RobotStatus>("status", kQueueSize)),
      run_project_(self_.advertiseService("run_project", &SimulatedControllerNode::runProject, this)),
      stop_project_(self_.advertiseService("stop_project", &SimulatedControllerNode::stopProject, this)),
      set_emergency_stop_(
          self_.advertiseService("set_emergency_stop", &SimulatedControllerNode::setEmergencyStop, this)),
      runtime_(std::move(parameters.arm), parameters.settings, optionsOf(parameters),
               {[this](const simulator::RobotState& state) { publish(state); },
                [](const simulator::LogLine& line) { ROS_DEBUG_STREAM_NAMED("traffic", line.text); }}) {}

Result<void, runtime::SimulatorError> SimulatedControllerNode::start() {
  const auto ports = runtime_.start();
  if (!ports) return refuse(ports.error());
  self_.setParam("listening/script_port", ports->script);
  self_.setParam("listening/status_port", ports->status);
  ROS_INFO("simulated controller: listening script=%d status=%d", ports->script, ports->status);
  return {};
}

simulator::OperatorReply SimulatedControllerNode::operate(const simulator::OperatorAction& action) {
  struct Answer {
    simulator::OperatorReply reply;
    std::promise<simulator::OperatorReply> promise;
  };
  auto answer = std::make_shared<Answer>();
  auto future = answer->promise.get_future();
  const bool posted =
      runtime_.post([action, answer](simulator::SimulatedController& controller,
                                     Instant now) { answer->reply = controller.operate(action, now); },
                    [answer] { answer->promise.set_value(answer->reply); });
  const simulator::OperatorReply shut_down{false, "the simulator is shutting down"};
  if (!posted) return shut_down;
  answer.reset();  // so that an action that is never come to breaks the promise
  try {
    return future.get();
  } catch (const std::future_error&) {
    return shut_down;
  }
}

bool SimulatedControllerNode::runProject(Trigger::Request& /*request*/, Trigger::Response& response) {
  return answer(operate(simulator::RunProject{}), response);
}

bool SimulatedControllerNode::stopProject(Trigger::Request& /*request*/, Trigger::Response& response) {
  return answer(operate(simulator::StopProject{}), response);
}

bool SimulatedControllerNode::setEmergencyStop(SetBool::Request& request, SetBool::Response& response) {
  return answer(operate(simulator::SetEmergencyStop{request.data != 0}), response);
}

void SimulatedControllerNode::publish(const simulator::RobotState& state) {
  const ros::Time stamp = ros::Time::now();
  joint_states_.publish(jointState(joint_names_, state.joints, &state.velocities, nullptr, stamp));
  geometry_msgs::PoseStamped tool;
  tool.header.stamp = stamp;
  tool.header.frame_id = base_frame_;
  tool.pose = toPoseMessage(state.flange * state.tcp);
  tool_pose_.publish(tool);
  status_.publish(toMessage(asStreamed(state), stamp));
}

}  // namespace cobot_command::ros_adapter
