#include "exchange/exchange_services.h"

#include <chrono>
#include <utility>

#include "action_parts/exchange_parts.h"

namespace cobot_command::ros_adapter {
namespace {

/// Far more than the core takes that works. Meanwhile no other callback is served.
constexpr std::chrono::milliseconds kPatience(500);

}  // namespace

ExchangeServices::ExchangeServices(const ros::NodeHandle& node, Update update) : update_(std::move(update)) {
  service_ = ros::NodeHandle(node).advertiseService("update_configuration",
                                                    &ExchangeServices::updateConfiguration, this);
}

bool ExchangeServices::updateConfiguration(cobot_command::UpdateConfiguration::Request& request,
                                           cobot_command::UpdateConfiguration::Response& response) {
  auto answer = update_(toSettings(request.par_cmd));
  if (!answer) {
    response.message = "the command layer is shutting down";
  } else if (answer->wait_for(kPatience) != std::future_status::ready) {
    response.message =
        "the command layer is busy, and has not answered yet: par_seq of the feedback tells when they rule";
  } else {
    const command::ExchangeAnswer found = answer->get();
    response.success = static_cast<std::uint8_t>(found.success);
    response.error_id = found.error_id;
    response.message = found.message;
  }
  return true;
}

}  // namespace cobot_command::ros_adapter
