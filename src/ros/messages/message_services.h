// The messages of the layer over ROS: a topic of each, a latched one of those that are pending, and the
// services that read and acknowledge them.
//
// The services wait for the core; take() may be called from the core's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/ReadMessages.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

class MessageServices {
 public:
  /// The core; each gives nothing once that is closed.
  struct Core {
    std::function<std::optional<std::future<command::ResetAnswer>>()> reset;
    std::function<std::optional<std::future<std::vector<command::Message>>>(command::Severity least,
                                                                            std::uint32_t after_id)>
        read;
  };

  MessageServices(const ros::NodeHandle& node, Core core);

  void take(const command::MessageRaised& raised, const ClockPair& clocks);
  void take(const command::PendingChanged& changed, const ClockPair& clocks);

 private:
  bool readMessages(cobot_command::ReadMessages::Request& request,
                    cobot_command::ReadMessages::Response& response);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  Core core_;
  ros::Publisher messages_;
  ros::Publisher pending_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace cobot_command::ros_adapter
