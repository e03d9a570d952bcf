// What people ask the supervisor of a cell for.
#pragma once

#include <functional>
#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/ConfirmClear.h"
#include "cobot_command/RecoverRobot.h"
#include "cobot_command/TakeOut.h"
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class PeopleServices {
 public:
  using Clock = std::function<Instant()>;

  /// `settle`: called behind each of them. `core` outlives this.
  PeopleServices(const ros::NodeHandle& node, cell::Supervision& core, Clock clock,
                 std::function<void(Instant now)> settle);

 private:
  template <class Service, class Ask>
  void serve(OwnHandle& node, const char* name, Ask ask);

  Clock clock_;
  std::function<void(Instant now)> settle_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace cobot_command::ros_adapter
