#include "cobot_command/blocks/shared/refusal_failure.h"

#include <cctype>
#include <string>

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

/// As a sentence: its first letter is a capital.
std::string sentence(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

}  // namespace

/// A refusal ends with what to do: that takes the place of the catalogue's remedy, which knows less of this
/// case. Both would be one too many.
Failure toFailure(const motion::Refusal& refusal) {
  const std::size_t end = refusal.message.rfind(": ");
  if (end == std::string::npos) return {idOf(refusal.reason), refusal.message, ""};
  return {idOf(refusal.reason), refusal.message.substr(0, end), sentence(refusal.message.substr(end + 2))};
}

}  // namespace cobot_command::blocks
