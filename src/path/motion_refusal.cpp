#include "motion_refusal.h"

#include <fmt/format.h>

#include "cobot_command/common/units.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::path {

int errorIdOf(motion::Refusal::Reason reason) {
  using Reason = motion::Refusal::Reason;
  switch (reason) {
    case Reason::NotFinite:
    case Reason::DegenerateCircle:
      return path_error::kTargetPose;
    case Reason::Unreachable:
      return path_error::kReach;
    case Reason::PoseBits:
      return path_error::kOtherConfiguration;
    case Reason::JointLimit:
      return path_error::kJointLimit;
    case Reason::JointSpeed:
      return path_error::kJointSpeed;
    case Reason::Singular:
      return path_error::kSingular;
    case Reason::AmbiguousTurn:
    case Reason::BadParameter:
      break;
  }
  return path_error::kNotPlannable;
}

std::string textOfFeedrate(double feedrate) {
  return feedrate == 1.0 ? ""
                         : fmt::format("; this applies to the feedrate of {:.6g} %", kPercent * feedrate);
}

}  // namespace cobot_command::path
