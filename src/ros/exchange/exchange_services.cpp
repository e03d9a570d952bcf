#include "exchange/exchange_services.h"

#include <utility>

#include "action_parts/exchange_parts.h"
#include "shared/core_answer.h"

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

ExchangeServices::ExchangeServices(const ros::NodeHandle& node, Update update) : update_(std::move(update)) {
  service_ =
      OwnHandle(node).advertiseService("update_configuration", &ExchangeServices::updateConfiguration, this);
}

bool ExchangeServices::updateConfiguration(cobot_command::UpdateConfiguration::Request& request,
                                           cobot_command::UpdateConfiguration::Response& response) {
  constexpr const char* kBusy =
      "the command layer is busy and has not answered yet: par_seq of the feedback shows when the values "
      "apply";
  const auto answer = answerOf(update_(toSettings(request.par_cmd)), response.message, kBusy);
  if (answer) fill(response, *answer);
  return true;
}

}  // namespace cobot_command::ros_adapter
