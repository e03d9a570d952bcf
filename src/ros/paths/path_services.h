// The services that control paths from outside of their goals, and the topic that tells their tracking
// objects.
//
// The services wait for the controller, on a thread that serves nothing else but such; take() may be called
// from the core's thread.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/SetFeedrate.h"
#include "cobot_command/SetTracking.h"
#include "cobot_command/command/path_requests.h"
#include "cobot_command/path/path_controls.h"

namespace cobot_command::ros_adapter {

class PathServices {
 public:
  /// The core; each gives nothing once that is closed.
  struct Core {
    std::function<std::optional<std::future<command::FeedrateAnswer>>(const command::FeedrateRequest&)>
        feedrate;
    /// The answer: nothing when it is switched, else why not.
    std::function<std::optional<std::future<std::optional<std::string>>>(const command::TrackingSwitch&)>
        tracking;
  };

  PathServices(const ros::NodeHandle& node, Core core);

  /// They are so now.
  void take(const path::PathControls& controls);

 private:
  bool setTracking(cobot_command::SetTracking::Request& request,
                   cobot_command::SetTracking::Response& response);
  bool setFeedrate(cobot_command::SetFeedrate::Request& request,
                   cobot_command::SetFeedrate::Response& response);
  bool stopOnPath(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool resumePath(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool trigger(const command::FeedrateRequest& request, std_srvs::Trigger::Response& response);
  [[nodiscard]] command::FeedrateAnswer asked(const command::FeedrateRequest& request);

  Core core_;
  ros::Publisher tracking_state_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace cobot_command::ros_adapter
