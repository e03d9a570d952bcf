// The seat of a mechanism in its cell: its agent, the topics between the agent and the supervisor, and the
// topics by which a PLC reports the position of the mechanism and receives its permitted position.
//
// It must be spun by one thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>

#include "cobot_command/CellState.h"
#include "cobot_command/cell/agent/mechanism_agent.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/ros/shared/given_parameters.h"

namespace cobot_command::ros_adapter {

struct MechanismParameters {
  std::string cell = "/cell";  ///< namespace of the supervisor
  std::string mechanism;       ///< the mechanism's name in the cell
  /// Absolute path of the file written by `tm_cell build`.
  std::string artifact;
  bool running = false;  ///< the mechanism runs from the start
  std::vector<std::string> warnings;
};

/// A row for each parameter; `parameters` must outlive the table.
[[nodiscard]] SettingTable settingsTable(MechanismParameters& parameters);
[[nodiscard]] Result<MechanismParameters, ParameterError> readMechanismParameters(
    const GivenParameters& given);

class MechanismNode {
 public:
  /// An error is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<MechanismNode>, std::string> of(
      const ros::NodeHandle& node, const MechanismParameters& parameters);

 private:
  MechanismNode(const ros::NodeHandle& node, const MechanismParameters& parameters,
                std::unique_ptr<cell::MechanismAgent> agent, Duration period);
  void measure(double position, Instant now);
  void tell(Instant now);
  bool run(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  std::unique_ptr<cell::MechanismAgent> agent_;
  std::optional<double> position_;
  std::optional<double> target_;  ///< the last published one
  ros::Publisher reports_;
  ros::Publisher targets_;
  ros::Subscriber states_;
  ros::Subscriber positions_;
  ros::Subscriber stops_;  ///< stop goals from the supervisor
  ros::ServiceServer run_;
  ros::SteadyTimer timer_;
};

}  // namespace cobot_command::ros_adapter
