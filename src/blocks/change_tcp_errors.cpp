#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> changeTcpErrors() {
  return ErrorTable(Block::ChangeTcp)
      .thesisCommand()
      .echoedCommandId()
      .anyCommand()
      .turn()
      .row(tcp_error::kWeightRange, "Weight range: 0~14 kg", kSetInRange,
           "weight is negative, above 14, or not a number")
      .row(own_error::kInertiaRange, "Moment of inertia range: 0~1000000000 kg mm^2", kSetInRange,
           "ixx, iyy or izz is negative, above 1000000000, or not a number")
      .shared({own_error::kNotFinite, own_error::kCoordinateRange, own_error::kNameInvalid})
      .rows();
}

}  // namespace cobot_command::blocks
