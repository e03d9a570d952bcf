#include "jog/jog_ends.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {

JogEnd jogEndOf(motion::Refusal::Reason reason) {
  using Reason = motion::Refusal::Reason;
  switch (reason) {
    case Reason::JointLimit:
      return JogEnd::JointLimit;
    case Reason::JointSpeed:
      return JogEnd::JointSpeed;
    case Reason::Singular:
      return JogEnd::Singularity;
    default:
      return JogEnd::Reach;
  }
}

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

const char* wayOutOf(JogEnd end) {
  switch (end) {
    case JogEnd::JointLimit:
      return "jog it the other way";
    case JogEnd::JointSpeed:
      return "jog more slowly, the other way, or its joints by AXES";
    case JogEnd::Singularity:
      return "jog the other way, or through it with AXES";
    default:
      return "jog the other way";
  }
}

}  // namespace cobot_command::blocks
