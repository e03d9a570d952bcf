#include "exchange/motion_permit.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {

using blocks::Failure;

std::vector<Failure> MotionPermit::objectionsTo(const blocks::GoalTraits& traits) const {
  if (traits.resumes && guard_.deniesResume()) {
    return {{blocks::interface_error::kInterrupted, text(), remedy()}};
  }
  if (!traits.may_move || traits.check_only) return {};
  std::vector<Failure> failures;
  if (exchange_.isRequired() && !exchange_.isEnabled()) {
    failures.push_back({blocks::interface_error::kNotEnabled, "", ""});
  }
  if (guard_.refuses()) {
    failures.push_back({blocks::interface_error::kNotSynchronized, sync_.whyNot(), remedy()});
  }
  if (guard_.interrupts() && traits.buffer_mode != blocks::BufferMode::Buffered) {
    failures.push_back({blocks::interface_error::kInterrupted, text(), remedy()});
  }
  return failures;
}

bool MotionPermit::holdsBack(const blocks::GoalTraits& traits, bool robot_stands) const {
  if (traits.may_move && guard_.interrupts()) return true;
  return traits.ends_blend && !robot_stands && exchange_.endsBlends();
}

std::string MotionPermit::text() const {
  const std::string why = guard_.deniesResume() ? sync_.whyNot() : "";
  return why.empty() ? "interrupted, because data were out of sync: program_control with RESUME continues it"
                     : "interrupted: " + why;
}

std::string MotionPermit::remedy() const {
  const bool only_waits = guard_.interrupts() && !guard_.deniesResume();
  return only_waits ? "RESUME with program_control, or stop" : sync_.remedy();
}

}  // namespace cobot_command::command
