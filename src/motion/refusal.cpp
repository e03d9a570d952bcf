#include "cobot_command/motion/refusal.h"

namespace cobot_command::motion {

const char* toString(Refusal::Reason reason) {
  switch (reason) {
    case Refusal::Reason::NotFinite:
      return "NOT_FINITE";
    case Refusal::Reason::BadParameter:
      return "BAD_PARAMETER";
    case Refusal::Reason::Unreachable:
      return "UNREACHABLE";
    case Refusal::Reason::PoseBits:
      return "POSE_BITS";
    case Refusal::Reason::JointLimit:
      return "JOINT_LIMIT";
    case Refusal::Reason::JointSpeed:
      return "JOINT_SPEED";
    case Refusal::Reason::Singular:
      return "SINGULAR";
    case Refusal::Reason::DegenerateCircle:
      return "DEGENERATE_CIRCLE";
    case Refusal::Reason::AmbiguousTurn:
      return "AMBIGUOUS_TURN";
  }
  return "UNKNOWN";
}

}  // namespace cobot_command::motion
