#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> stopErrors() {
  return ErrorTable(Block::Stop)
      .shared({motion_error::kNotConnected})
      .shared(motion_error::kLinkDropped, "the link dropped before the robot was seen to stand")
      .shared(
          own_error::kStopNotConfirmed,
          "the controller did not accept the stop, as it does outside the Listen node (CPERR F1), or did not "
          "answer, or the status stream did not show the robot come to rest in time: the robot may still "
          "move")
      .shared({own_error::kShutDown})
      .rows();
}

}  // namespace cobot_command::blocks
