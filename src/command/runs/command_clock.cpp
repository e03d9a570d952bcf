#include "runs/command_clock.h"

#include "cobot_command/common/deadline.h"

namespace cobot_command::command {

void CommandClock::hold(Instant now) {
  if (!held_since_) held_since_ = now;
}

void CommandClock::release(Instant now) {
  if (!held_since_) return;
  const Duration pause = now - *held_since_;
  held_since_.reset();
  for (std::optional<Instant>* at : {&begins_at_, &executing_from_, &deadline_, &kept_}) {
    if (*at) **at += pause;
  }
  waits_from_ += pause;
  give_up_at_ += pause;
}

void CommandClock::expect(Instant now, Duration start_delay, Duration time) {
  if (held_since_) held_since_ = now;
  deadline_ = now + time;
  if (start_delay > Duration::zero()) begins_at_ = now + start_delay;
}

bool CommandClock::beginsNow(Instant now) const {
  return begins_at_ && !waits(now) && !executing_from_ && !held();
}

void CommandClock::execute(Instant now) {
  if (!executing_from_) executing_from_ = now;
}

Duration CommandClock::executed(Instant now) const {
  return executing_from_ ? now - *executing_from_ : Duration::zero();
}

void CommandClock::prolong(Duration by) {
  if (deadline_) *deadline_ += by;
  if (kept_) *kept_ += by;
}

void CommandClock::ask(bool early) {
  kept_ = early ? deadline_ : std::nullopt;
  deadline_.reset();
}

void CommandClock::goOn(Instant otherwise) {
  deadline_ = kept_.value_or(otherwise);
  kept_.reset();
}

void CommandClock::clear() {
  begins_at_.reset();
  deadline_.reset();
  kept_.reset();
  held_since_.reset();
}

std::optional<Instant> CommandClock::next() const {
  if (held()) return std::nullopt;
  return executing_from_ ? deadline_ : earlier(begins_at_, deadline_);
}

}  // namespace cobot_command::command
