// The services that interrupt what is under way, and let it go on. They wait for the
// controller.
#pragma once

#include <functional>
#include <future>
#include <optional>

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "cobot_command/Interruption.h"
#include "cobot_command/command/interruption.h"

namespace cobot_command::ros_adapter {

class InterruptionServices {
 public:
  /// Of the core; gives nothing once that is closed.
  using Ask = std::function<std::optional<std::future<command::InterruptAnswer>>()>;

  InterruptionServices(const ros::NodeHandle& node, Ask interrupt, Ask go_on);

 private:
  using Request = cobot_command::Interruption::Request;
  using Response = cobot_command::Interruption::Response;
  bool interrupt(Request& request, Response& response);
  bool goOn(Request& request, Response& response);

  Ask interrupt_;
  Ask go_on_;
  ros::ServiceServer of_interrupt_;
  ros::ServiceServer of_continue_;
};

}  // namespace cobot_command::ros_adapter
