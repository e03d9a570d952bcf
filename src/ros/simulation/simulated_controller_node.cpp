#include "cobot_command/ros/simulation/simulated_controller_node.h"

#include <array>
#include <cstdint>
#include <future>
#include <memory>
#include <utility>

#include "shared/robot_status_message.h"
#include <boost/function.hpp>
#include <fmt/format.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/RaiseError.h"
#include "cobot_command/SetBase.h"
#include "cobot_command/SetFault.h"
#include "cobot_command/SetInput.h"
#include "cobot_command/SetLoad.h"
#include "cobot_command/SetProjectSpeed.h"
#include "cobot_command/SetTcp.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr const char* kPorts = "listening";
constexpr const char* kScriptPort = "listening/script_port";
constexpr const char* kStatusPort = "listening/status_port";

runtime::SimulatorOptions optionsOf(const SimulatorParameters& parameters) {
  runtime::SimulatorOptions options = parameters.simulator.options;
  options.state_period = fromSeconds(1.0 / parameters.publish_rate);
  options.tells_states = false;
  return options;
}

/// The truth in the words of the status stream, so that both make the same message.
link::RobotStatus asStreamed(const simulator::RobotState& state) {
  link::RobotStatus status;
  status.operating_mode = static_cast<int>(state.mode);
  status.emergency_stop = state.emergency_stop;
  status.safeguard = state.safeguard;
  status.error = state.error;
  status.error_code = state.error_code;
  status.error_text = foreignText(state.error_text);
  status.project_running = state.project_running;
  status.project_paused = state.project_paused;
  status.project_speed_percent = state.project_speed_percent;
  status.base_name = foreignText(state.base_name);
  status.tcp_name = foreignText(state.tcp_name);
  return status;
}

Result<simulator::OperatorAction, std::string> inputOf(const SetInput::Request& request) {
  const auto module = script::ioModule(request.module);
  if (!module) {
    return refuse("module \"" + foreignText(request.module, kQuoteLimit) +
                  "\": the modules are ControlBox and EndModule");
  }
  return simulator::SetInput{*module, request.input, request.value != 0};
}

simulator::SetLoad loadOf(const SetLoad::Request& request) {
  const MomentOfInertia& moment = request.moment_of_inertia;
  return {request.name, request.mass, std::array<double, 3>{moment.ixx, moment.iyy, moment.izz},
          toSix(request.mass_center)};
}

void logTraffic(const simulator::LogLine& line) {
  ROS_INFO_STREAM_NAMED(
      "traffic", fmt::format("{:.3f} {}", toSeconds(line.time.time_since_epoch()), forPeople(line.text)));
}
void noteTraffic(const simulator::LogLine& line) {
  ROS_DEBUG_STREAM_NAMED("traffic", forPeople(line.text));
}

}  // namespace

SimulatedControllerNode::SimulatedControllerNode(const ros::NodeHandle& self, SimulatorParameters parameters)
    : self_(self),
      joint_names_(jointNames(parameters.prefix)),
      base_frame_(parameters.prefix + "base"),
      joint_states_(topic<sensor_msgs::JointState>("joint_states")),
      tool_pose_(topic<geometry_msgs::PoseStamped>("tool_pose")),
      status_(topic<cobot_command::RobotStatus>("status")),
      runtime_(std::move(parameters.arm), parameters.simulator.settings, optionsOf(parameters),
               {[this](const simulator::RobotState& state) { publish(state); },
                parameters.simulator.log_traffic ? logTraffic : noteTraffic}) {
  offerServices();
}

SimulatedControllerNode::~SimulatedControllerNode() {
  int script = 0;
  int status = 0;
  const bool ours = told_ && self_.getParam(kScriptPort, script) && self_.getParam(kStatusPort, status) &&
                    script == told_->script && status == told_->status;
  if (ours) self_.deleteParam(kPorts);  // else they are those of a new node of this name
}

Result<void, runtime::SimulatorError> SimulatedControllerNode::start() {
  self_.deleteParam(kPorts);  // of a run that was killed, which nobody shall connect to
  const auto ports = runtime_.start();
  if (!ports) return refuse(ports.error());
  told_ = *ports;
  self_.setParam(kScriptPort, ports->script);
  self_.setParam(kStatusPort, ports->status);
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
  simulator::OperatorReply shut_down{false, "the simulator is shutting down"};
  if (!posted) return shut_down;
  answer.reset();  // so that an action that is never come to breaks the promise
  try {
    return future.get();
  } catch (const std::future_error&) {
    return shut_down;
  }
}

template <class Service, class ToAction>
void SimulatedControllerNode::offer(const std::string& name, ToAction to_action) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> serve = [this, to_action](Request& request,
                                                                             Response& response) {
    const Result<simulator::OperatorAction, std::string> action = to_action(request);
    simulator::OperatorReply reply =
        action ? operate(*action) : simulator::OperatorReply{false, action.error()};
    response.success = reply.done;
    response.message = forPeople(std::move(reply.text));
    return true;
  };
  services_.push_back(self_.advertiseService(name, serve));
}

template <class Action>
void SimulatedControllerNode::offerTrigger(const std::string& name) {
  offer<std_srvs::Trigger>(name, [](const auto&) { return Action{}; });
}

template <class Action>
void SimulatedControllerNode::offerSwitch(const std::string& name) {
  offer<std_srvs::SetBool>(name, [](const auto& request) { return Action{request.data != 0}; });
}

void SimulatedControllerNode::offerServices() {
  offerTrigger<simulator::RunProject>("run_project");
  offerTrigger<simulator::StopProject>("stop_project");
  offerTrigger<simulator::PauseProject>("pause_project");
  offerTrigger<simulator::ResumeProject>("resume_project");
  offerTrigger<simulator::LeaveListenNode>("leave_listen_node");
  offerTrigger<simulator::EnterListenNode>("enter_listen_node");
  offerTrigger<simulator::ClearError>("clear_error");
  offerTrigger<simulator::ClearFaults>("clear_faults");
  offerTrigger<simulator::DropConnections>("drop_connections");
  offerSwitch<simulator::SetEmergencyStop>("set_emergency_stop");
  offerSwitch<simulator::SetSafeguard>("set_safeguard");
  offer<std_srvs::SetBool>("set_manual_mode", [](const auto& request) {
    using Mode = simulator::OperatingMode;
    return simulator::SetOperatingMode{request.data != 0 ? Mode::Manual : Mode::Automatic};
  });
  offer<SetProjectSpeed>("set_project_speed",
                         [](const auto& request) { return simulator::SetProjectSpeed{request.percent}; });
  offer<RaiseError>("raise_error", [](const auto& request) {
    return simulator::RaiseError{request.code, request.text};
  });
  offer<SetInput>("set_input", [](const auto& request) { return inputOf(request); });
  offer<SetTcp>("set_tcp", [](const auto& request) {
    return simulator::SetTcp{request.name, toSix(request.value)};
  });
  offer<SetBase>("set_base", [](const auto& request) {
    return simulator::SetBase{request.name, toSix(request.value)};
  });
  offer<SetLoad>("set_load", [](const auto& request) { return loadOf(request); });
  offer<SetFault>("set_fault", [](const auto& request) {
    return simulator::SetFault{request.fault, request.active != 0, request.count, request.value,
                               request.text};
  });
}

template <class Message>
ros::Publisher SimulatedControllerNode::topic(const std::string& name) {
  // Called on the spinner, which is not here yet while the node is made.
  const auto count = [this](const ros::SingleSubscriberPublisher&) {
    const auto listeners =
        joint_states_.getNumSubscribers() + tool_pose_.getNumSubscribers() + status_.getNumSubscribers();
    runtime_.tellStates(listeners > 0);
  };
  return self_.advertise<Message>(name, kQueueSize, count, count);
}

void SimulatedControllerNode::publish(const simulator::RobotState& state) {
  const ros::Time stamp = ros::Time::now();
  if (joint_states_.getNumSubscribers() > 0) {
    joint_states_.publish(jointState(joint_names_, state.joints, &state.velocities, nullptr, stamp));
  }
  if (tool_pose_.getNumSubscribers() > 0) {
    geometry_msgs::PoseStamped tool;
    tool.header.stamp = stamp;
    tool.header.frame_id = base_frame_;
    tool.pose = toPoseMessage(state.flange * state.tcp);
    tool_pose_.publish(tool);
  }
  if (status_.getNumSubscribers() > 0) status_.publish(toMessage(asStreamed(state), state.in_motion, stamp));
}

}  // namespace cobot_command::ros_adapter
