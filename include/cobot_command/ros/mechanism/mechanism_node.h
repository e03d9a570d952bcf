// A mechanism's seat in its cell: its agent, the topics by which it and the supervisor hear of each other,
// and those by which a PLC tells where it is and hears where it may move.
//
// To be spun by one thread.
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
  std::string mechanism;       ///< its name in the cell
  std::string artifact;        ///< absolute path of what tm_cell build has made of the cell
  bool running = false;        ///< it runs from the start
  std::vector<std::string> warnings;
};

/// A row for each; `parameters` outlives them.
[[nodiscard]] SettingTable settingsTable(MechanismParameters& parameters);
[[nodiscard]] Result<MechanismParameters, ParameterError> readMechanismParameters(
    const GivenParameters& given);

class MechanismNode {
 public:
  /// A fault is a sentence.
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
  std::optional<double> target_;  ///< that was told last
  ros::Publisher reports_;
  ros::Publisher targets_;
  ros::Subscriber states_;
  ros::Subscriber positions_;
  ros::Subscriber stops_;  ///< goals of the supervisor's stops
  ros::ServiceServer run_;
  ros::SteadyTimer timer_;
};

}  // namespace cobot_command::ros_adapter
