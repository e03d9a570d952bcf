#include "paths/path_services.h"

#include <utility>

#include "shared/core_answer.h"

#include "cobot_command/TrackingState.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

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
  OwnHandle handle(node);
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
  const auto refusal =
      answerOf(core_.tracking({request.object, request.enabled != 0, request.automatic != 0}),
               response.message, "the command layer is busy and has not answered yet: see tracking_state");
  if (!refusal) return true;
  response.success = static_cast<std::uint8_t>(!*refusal);
  response.message = forPeople(refusal->value_or(""));
  return true;
}

command::FeedrateAnswer PathServices::asked(const command::FeedrateRequest& request) {
  command::FeedrateAnswer none;
  const auto answer =
      answerOf(core_.feedrate(request), none.message, "requested; the controller has not confirmed it yet");
  return answer.value_or(none);
}

bool PathServices::setFeedrate(cobot_command::SetFeedrate::Request& request,
                               cobot_command::SetFeedrate::Response& response) {
  const command::FeedrateAnswer answer = asked({request.percent, request.restart != 0});
  fill(response, answer);
  response.effective = answer.effective;
  response.from_point = answer.from_point;
  return true;
}

bool PathServices::trigger(const command::FeedrateRequest& request, std_srvs::Trigger::Response& response) {
  const command::FeedrateAnswer answer = asked(request);
  response.success = static_cast<std::uint8_t>(answer.success);
  response.message = forPeople(answer.message);
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
