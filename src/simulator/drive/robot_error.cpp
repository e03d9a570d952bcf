#include "drive/robot_error.h"

#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

int codeFor(motion::Refusal::Reason reason, bool reaches_end) {
  using Reason = motion::Refusal::Reason;
  switch (reason) {
    case Reason::Unreachable:
      return reaches_end ? 0x12 : 0x01;  // IK failed: in interpolation; working range
    case Reason::DegenerateCircle:
      return 0x15;  // circle
    case Reason::BadParameter:
    case Reason::JointSpeed:
      return 0x21;  // speed over range
    case Reason::NotFinite:
    case Reason::PoseBits:
      return 0x14058;  // IK failed
    case Reason::JointLimit:
      return 0x1405A;  // joint outside its range
    case Reason::Singular:
      return 0x14064;  // singular
    case Reason::AmbiguousTurn:
      break;  // the arm itself takes one of both ways
  }
  return 0x14058;
}

}  // namespace

RobotError robotErrorFor(const motion::Refusal& refusal, bool reaches_end) {
  return {codeFor(refusal.reason, reaches_end),
          std::string(motion::toString(refusal.reason)) + ": " + refusal.message};
}

std::optional<RobotError> overload(const arm::ArmModel& arm, double tool, double load) {
  constexpr int kForceOverRange = 0x22;
  const double rated = arm.ratings().payload;
  if (tool >= 0 && load >= 0 && tool + load <= rated) return std::nullopt;
  return RobotError{kForceOverRange,
                    fmt::format("OVERLOAD: the tool has {} kg and the load {} kg, {} carries 0 "
                                "to {} kg: check ChangeTCP and ChangeLoad",
                                tool, load, arm.name(), rated)};
}

void ErrorLatch::on(ErrorEvent event, RobotError error) {
  const auto row = findTransition<ErrorTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  error_.reset();
  if (row->action == ErrorAction::Keep) error_ = std::move(error);
}

}  // namespace cobot_command::simulator
