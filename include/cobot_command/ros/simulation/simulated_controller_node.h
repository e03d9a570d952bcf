// The simulated controller as a ROS node: topics with its true state, and services for the operator's
// actions.
//
// Clients command it over TCP like a real controller. ROS is only for observation and for the operator.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include "cobot_command/common/result.h"
#include "cobot_command/ros/shared/conversions.h"
#include "cobot_command/ros/shared/own_handle.h"
#include "cobot_command/ros/simulation/simulator_parameters.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"

namespace cobot_command::ros_adapter {

class SimulatedControllerNode {
 public:
  /// Topics, services and parameters are relative to `self`, the node's private namespace.
  SimulatedControllerNode(const ros::NodeHandle& self, SimulatorParameters parameters);
  ~SimulatedControllerNode();  ///< removes the ports that start() has published
  SimulatedControllerNode(const SimulatedControllerNode&) = delete;
  SimulatedControllerNode& operator=(const SimulatedControllerNode&) = delete;

  /// Serves clients, and writes the ports to ~listening/script_port and ~listening/status_port.
  [[nodiscard]] Result<void, runtime::SimulatorError> start();

 private:
  void offerServices();
  /// A service that carries out the action that `to_action` creates from its request.
  template <class Service, class ToAction>
  void offer(const std::string& name, ToAction to_action);
  /// A service of std_srvs/Trigger.
  template <class Action>
  void offerTrigger(const std::string& name);
  /// A service of std_srvs/SetBool.
  template <class Action>
  void offerSwitch(const std::string& name);
  /// Returns when the action is done, so that its effect is visible to the caller.
  simulator::OperatorReply operate(const simulator::OperatorAction& action);
  /// A topic of the true state, which is published only while one of these topics has a subscriber.
  template <class Message>
  ros::Publisher topic(const std::string& name);
  void publish(const simulator::RobotState& state);  // on the simulator's thread

  OwnHandle self_;
  JointNames joint_names_;
  std::string base_frame_;
  ros::Publisher joint_states_;
  ros::Publisher tool_pose_;
  ros::Publisher status_;
  std::vector<ros::ServiceServer> services_;
  std::optional<runtime::SimulatorPorts> told_;
  runtime::SimulatorRuntime runtime_;  // last: its thread uses the publishers
};

}  // namespace cobot_command::ros_adapter
