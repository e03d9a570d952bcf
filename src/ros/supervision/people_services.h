// The services of a cell for operators. `stop` is served on the node's thread: it waits for nothing. The
// others are answered by the core, which may wait for the disk of its journal; they have a thread of their
// own.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <vector>

#include <ros/callback_queue_interface.h>
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
  using Question = std::function<cell::PersonsAnswer(cell::Supervision& core, Instant now)>;

  struct Ports {
    std::function<void()> stop;
    /// Asks the core; nothing: the node is ending.
    std::function<std::optional<std::future<cell::PersonsAnswer>>(Question question)> ask;
  };

  /// `stops`: serves `stop`. `questions`: serves the others; its thread waits for their answers.
  PeopleServices(const ros::NodeHandle& node, ros::CallbackQueueInterface& stops,
                 ros::CallbackQueueInterface& questions, Ports ports);

 private:
  template <class Service, class Ask>
  void serve(OwnHandle& node, const char* name, Ask ask);
  [[nodiscard]] cell::PersonsAnswer answerTo(Question question) const;

  Ports ports_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace cobot_command::ros_adapter
