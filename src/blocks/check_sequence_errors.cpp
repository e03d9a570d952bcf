#include "error_tables.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

std::vector<ErrorEntry> checkSequenceErrors() {
  return ErrorTable(Block::CheckSequence)
      .row(own_error::kStartUnknown, "Start unknown",
           "Give six start_joints, or wait until the status stream shows the robot standing",
           "start_joints are neither six finite numbers nor empty; or they are empty and nobody knows "
           "where the robot is, or where what was sent will leave it")
      .shared(own_error::kNoModel, "the command layer knows no model of the arm")
      .shared({own_error::kShutDown})
      .shared(own_error::kStepCount, "there are no steps, or more than 200")
      .shared({own_error::kStepRefused})
      .row(own_error::kStepsUnreadable, "Steps cannot be read",
           "Set the kind of each step to one that SequenceStep lists", "a step has a kind that is none")
      .rows();
}

}  // namespace cobot_command::blocks
