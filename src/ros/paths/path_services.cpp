#include "paths/path_services.h"

#include <chrono>
#include <utility>

#include "cobot_command/TrackingState.h"

namespace cobot_command::ros_adapter {
namespace {

/// Far more than a controller takes that works. Meanwhile no other callback is served.
constexpr std::chrono::milliseconds kPatience(500);

constexpr const char* kClosed = "the command layer is shutting down";

command::FeedrateAnswer notAnswered(const char* why) {
  command::FeedrateAnswer answer;
  answer.message = why;
  return answer;
}

cobot_command::TrackingState toMessage(const path::TrackingObjects& objects) {
  cobot_command::TrackingState message;
  message.header.stamp = ros::Time::now();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    message.on[i] = static_cast<std::uint8_t>(objects[i].on);
    message.automatic[i] = static_cast<std::uint8_t>(objects[i].automatic);
  }
  return message;
}

}  // namespace

PathServices::PathServices(const ros::NodeHandle& node, Core core) : core_(std::move(core)) {
  ros::NodeHandle handle(node);
  tracking_state_ = handle.advertise<cobot_command::TrackingState>("tracking_state", 1, true);
  take({});
  services_.push_back(handle.advertiseService("set_tracking", &PathServices::setTracking, this));
  services_.push_back(handle.advertiseService("set_feedrate", &PathServices::setFeedrate, this));
  services_.push_back(handle.advertiseService("stop_on_path", &PathServices::stopOnPath, this));
  services_.push_back(handle.advertiseService("resume_path", &PathServices::resumePath, this));
}

void PathServices::take(const path::PathControls& controls) {
  tracking_state_.publish(toMessage(controls.tracking));
}

bool PathServices::setTracking(cobot_command::SetTracking::Request& request,
                               cobot_command::SetTracking::Response& response) {
  auto answer = core_.tracking({request.object, request.enabled != 0, request.automatic != 0});
  if (!answer) {
    response.message = kClosed;
  } else if (answer->wait_for(kPatience) != std::future_status::ready) {
    response.message = "the command layer is busy, and has not answered yet: see tracking_state";
  } else {
    const auto refusal = answer->get();
    response.success = static_cast<std::uint8_t>(!refusal);
    response.message = refusal.value_or("");
  }
  return true;
}

command::FeedrateAnswer PathServices::asked(const command::FeedrateRequest& request) {
  auto answer = core_.feedrate(request);
  if (!answer) return notAnswered(kClosed);
  if (answer->wait_for(kPatience) == std::future_status::ready) return answer->get();
  return notAnswered("asked for; the controller has not confirmed it yet");
}

bool PathServices::setFeedrate(cobot_command::SetFeedrate::Request& request,
                               cobot_command::SetFeedrate::Response& response) {
  const command::FeedrateAnswer answer = asked({request.percent, request.restart != 0});
  response.success = static_cast<std::uint8_t>(answer.success);
  response.error_id = answer.error_id;
  response.message = answer.message;
  response.effective = answer.effective;
  response.from_point = answer.from_point;
  return true;
}

bool PathServices::trigger(const command::FeedrateRequest& request, std_srvs::Trigger::Response& response) {
  const command::FeedrateAnswer answer = asked(request);
  response.success = static_cast<std::uint8_t>(answer.success);
  response.message = answer.message;
  return true;
}

bool PathServices::stopOnPath(std_srvs::Trigger::Request& /*request*/,
                              std_srvs::Trigger::Response& response) {
  return trigger({0.0}, response);
}

bool PathServices::resumePath(std_srvs::Trigger::Request& /*request*/,
                              std_srvs::Trigger::Response& response) {
  return trigger({std::nullopt}, response);
}

}  // namespace cobot_command::ros_adapter
