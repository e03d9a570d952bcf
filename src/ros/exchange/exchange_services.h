// The service that changes the settings of the exchange_configuration goal that is enabled.
#pragma once

#include <functional>
#include <future>
#include <optional>

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "cobot_command/UpdateConfiguration.h"
#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/command/exchange_answer.h"

namespace cobot_command::ros_adapter {

class ExchangeServices {
 public:
  /// Of the core; gives nothing once that is closed.
  using Update =
      std::function<std::optional<std::future<command::ExchangeAnswer>>(const blocks::ExchangeSettings&)>;

  ExchangeServices(const ros::NodeHandle& node, Update update);

 private:
  bool updateConfiguration(cobot_command::UpdateConfiguration::Request& request,
                           cobot_command::UpdateConfiguration::Response& response);

  Update update_;
  ros::ServiceServer service_;
};

}  // namespace cobot_command::ros_adapter
