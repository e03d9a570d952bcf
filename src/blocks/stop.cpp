#include "cobot_command/blocks/stop.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {

ErrorTable StopGoal::errors() {
  return ErrorTable()
      .shared({motion_error::kNotConnected})
      .shared(motion_error::kLinkDropped, "the link dropped before the robot was confirmed at standstill")
      .shared(
          own_error::kStopNotConfirmed,
          "the controller did not accept the stop, as outside the Listen node (CPERR F1), or did not answer, "
          "or the status stream did not show the robot at standstill in time: the robot may still move")
      .shared({own_error::kShutDown});
}

GoalTraits traitsOf(const StopGoal& /*goal*/) {
  GoalTraits traits;
  traits.way = Way::Stop;
  traits.halts = true;
  return traits;
}

std::vector<Failure> check(const StopGoal& /*goal*/) {
  return {};
}

}  // namespace cobot_command::blocks
