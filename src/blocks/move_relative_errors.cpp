#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> moveRelativeErrors() {
  return ErrorTable(Block::MoveRelative)
      .thesisCommand()
      .anyCommand()
      .turn()
      .move()
      .row(relative_error::kFormatForPtp, "DataFormat invalid for PTP command", kSetInRange,
           "PTP with a data_format other than JPP (0), CPP (1) or TPP (5), known or unknown")
      .row(relative_error::kFormatForLine, "DataFormat invalid for Line command", kSetInRange,
           "Line with JPP (0) or an unknown data_format")
      .shared({own_error::kBlendingTooLarge, own_error::kMovementUnknown})
      .rows();
}

}  // namespace cobot_command::blocks
