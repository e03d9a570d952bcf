#include "cobot_command/blocks/shared/refusal_failure.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

int idOf(motion::Refusal::Reason reason) {
  using Reason = motion::Refusal::Reason;
  switch (reason) {
    case Reason::NotFinite:
      return own_error::kNotFinite;
    case Reason::Unreachable:
      return own_error::kUnreachable;
    case Reason::PoseBits:
      return own_error::kPoseBits;
    case Reason::JointLimit:
      return own_error::kJointLimit;
    case Reason::JointSpeed:
      return own_error::kJointSpeed;
    case Reason::Singular:
      return own_error::kSingular;
    case Reason::AmbiguousTurn:
      return own_error::kAmbiguousTurn;
    case Reason::BadParameter:
    case Reason::DegenerateCircle:
      break;
  }
  return own_error::kNotPlannable;
}

}  // namespace

Failure toFailure(const motion::Refusal& refusal) {
  return {idOf(refusal.reason), refusal.message, ""};
}

}  // namespace cobot_command::blocks
