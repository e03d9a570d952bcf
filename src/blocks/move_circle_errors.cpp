#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> moveCircleErrors() {
  return ErrorTable(Block::MoveCircle)
      .thesisCommand()
      .anyCommand()
      .turn()
      .move()
      .framedPose()
      .row(own_error::kArcAngleRange, "ArcAngle range: 0~360 degrees", kSetInRange,
           "arc_angle is negative, above 360, or not a number")
      .row(own_error::kFormatForCircle, "DataFormat invalid for Circle command", "Use 0 (CPP) or 1 (CAP)",
           "data_format is neither 0 nor 1")
      .rows();
}

}  // namespace cobot_command::blocks
