#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> pickAndPlaceErrors() {
  return ErrorTable(Block::PickAndPlace)
      .turn()
      .shared({motion_error::kNotConnected, motion_error::kLinkDropped, own_error::kStartUnknown,
               own_error::kNoModel, own_error::kShutDown})
      .shared(own_error::kStepCount, "there are no steps, or more than 50")
      .shared({own_error::kStepRefused})
      .row(own_error::kStepFailed, "Step failed", kExecuteAgain,
           "a move of the cycle failed in execution; the description tells its error and which step")
      .row(own_error::kDwellRange, "Dwell range: 0~3600 s", kSetInRange,
           "the dwell of a step is negative, above 3600, or not a number")
      .row(own_error::kCycleRange, "Cycles range: 0~1000000", kSetInRange,
           "cycles is negative or above 1000000; 0 means until cancelled")
      .row(own_error::kOutputInvalid, "Output invalid", "Use 0 to 3 of EndModule, or 0 to 15 of ControlBox",
           "the output of a step is of another module, or has no such number")
      .row(own_error::kStepsUnreadable, "Steps cannot be read",
           "Check the path of the file, and its form against config/pick_and_place.yaml",
           "steps_file is not there, is no YAML, or has other fields than a step")
      .row(own_error::kOutputFailed, "Output not set", "Check that the controller has this output",
           "the controller refused or did not answer the line that sets an output, or it could not be sent; "
           "the description tells why")
      .row(own_error::kBlendBeforeDwell, "Blending must be disabled before an output or a dwell",
           "Disable blending_enable of the step", "a step with blending_enable has an output or a dwell")
      .row(own_error::kExitBeforeEnd, "Only the last step of the last cycle may leave the Listen node",
           "Take exit_node away from the step, or its output; give a number of cycles",
           "exit_node of a step that is not the last, of one with an output, or with cycles 0")
      .rows();
}

}  // namespace cobot_command::blocks
