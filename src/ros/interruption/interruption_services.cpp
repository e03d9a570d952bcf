#include "interruption/interruption_services.h"

#include <utility>

#include "shared/core_answer.h"

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

InterruptionServices::InterruptionServices(const ros::NodeHandle& node, Ask interrupt, Ask go_on)
    : interrupt_(std::move(interrupt)), go_on_(std::move(go_on)) {
  OwnHandle handle(node);
  of_interrupt_ = handle.advertiseService("interrupt", &InterruptionServices::interrupt, this);
  of_continue_ = handle.advertiseService("continue", &InterruptionServices::goOn, this);
}

/// A heavy arm takes longer to come to rest than callbacks may wait: then it is told by the state.
bool InterruptionServices::interrupt(Request& /*request*/, Response& response) {
  constexpr const char* kStopping =
      "the robot is being stopped: sequence of group_state is INTERRUPTED (2) when it is at standstill and "
      "all goals are kept";
  auto asked = interrupt_();
  const bool is_asked = asked.has_value();
  const auto answer = answerOf(std::move(asked), response.message, kStopping);
  if (answer) {
    fill(response, *answer);
  } else {
    response.success = static_cast<std::uint8_t>(is_asked && response.message == kStopping);
  }
  return true;
}

bool InterruptionServices::goOn(Request& /*request*/, Response& response) {
  if (const auto answer = answerOf(go_on_(), response.message)) fill(response, *answer);
  return true;
}

}  // namespace cobot_command::ros_adapter
