#include "jog/jog_ends.h"

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/refusal_failure.h"

namespace cobot_command::blocks {

JogEnd jogEndOf(int error_id) {
  switch (error_id) {
    case own_error::kJointLimit:
      return JogEnd::JointLimit;
    case own_error::kJointSpeed:
      return JogEnd::JointSpeed;
    case own_error::kSingular:
      return JogEnd::Singularity;
    case own_error::kUnreachable:
      return JogEnd::Reach;
    default:
      return JogEnd::None;
  }
}

/// What nothing better is known of is as far as the arm can go.
JogEnd jogEndOf(const motion::Refusal& obstacle) {
  const JogEnd end = jogEndOf(toFailure(obstacle).error_id);
  return end == JogEnd::None ? JogEnd::Reach : end;
}

const char* wayOutOf(JogEnd end) {
  switch (end) {
    case JogEnd::JointLimit:
      return "jog it in the other direction";
    case JogEnd::JointSpeed:
      return "jog more slowly, in the other direction, or by joints (AXES)";
    case JogEnd::Singularity:
      return "jog in the other direction, or pass the singularity with AXES";
    default:
      return "jog in the other direction";
  }
}

}  // namespace cobot_command::blocks
