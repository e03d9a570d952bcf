#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> changeBaseErrors() {
  return ErrorTable(Block::ChangeBase)
      .thesisCommand()
      .echoedCommandId()
      .anyCommand()
      .turn()
      .framedPose()
      .shared({own_error::kNotFinite, own_error::kCoordinateRange, own_error::kNameInvalid})
      .rows();
}

}  // namespace cobot_command::blocks
