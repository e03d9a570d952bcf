// The services of speeds and limits: speed override, reference and default dynamics, software limits. They
// wait for the core, and some for the controller.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "cobot_command/ChangeSpeedOverride.h"
#include "cobot_command/ReadDefaultDynamics.h"
#include "cobot_command/ReadReferenceDynamics.h"
#include "cobot_command/ReadSoftwareLimits.h"
#include "cobot_command/WriteDefaultDynamics.h"
#include "cobot_command/WriteReferenceDynamics.h"
#include "cobot_command/WriteSoftwareLimits.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/command/dynamics.h"
#include "cobot_command/command/speed_override.h"

namespace cobot_command::ros_adapter {

class DynamicsServices {
 public:
  template <class Answer>
  using Asked = std::optional<std::future<Answer>>;
  /// The core; each gives nothing once that is closed.
  struct Core {
    std::function<Asked<command::OverrideAnswer>(double percent)> set_override;
    std::function<Asked<std::optional<command::ReferenceDynamics>>()> reference;
    std::function<Asked<blocks::DefaultDynamics>()> defaults;
    std::function<Asked<command::DynamicsAnswer>(const blocks::DefaultDynamics&)> write_defaults;
    std::function<Asked<std::optional<command::LimitsReport>>()> limits;
    std::function<Asked<command::DynamicsAnswer>(const command::SoftwareLimits&)> write_limits;
  };

  DynamicsServices(const ros::NodeHandle& node, Core core);

 private:
  bool changeSpeedOverride(cobot_command::ChangeSpeedOverride::Request& request,
                           cobot_command::ChangeSpeedOverride::Response& response);
  bool readReference(cobot_command::ReadReferenceDynamics::Request& request,
                     cobot_command::ReadReferenceDynamics::Response& response);
  static bool writeReference(cobot_command::WriteReferenceDynamics::Request& request,
                             cobot_command::WriteReferenceDynamics::Response& response);
  bool readDefaults(cobot_command::ReadDefaultDynamics::Request& request,
                    cobot_command::ReadDefaultDynamics::Response& response);
  bool writeDefaults(cobot_command::WriteDefaultDynamics::Request& request,
                     cobot_command::WriteDefaultDynamics::Response& response);
  bool readLimits(cobot_command::ReadSoftwareLimits::Request& request,
                  cobot_command::ReadSoftwareLimits::Response& response);
  bool writeLimits(cobot_command::WriteSoftwareLimits::Request& request,
                   cobot_command::WriteSoftwareLimits::Response& response);

  Core core_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace cobot_command::ros_adapter
