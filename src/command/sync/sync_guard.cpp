#include "sync/sync_guard.h"

namespace cobot_command::command {

void SyncGuard::begin(Duration delay, blocks::SyncReaction reaction) {
  is_active_ = true;
  operates_ = is_due_ = false;
  since_.reset();
  change(delay, reaction);
}

void SyncGuard::change(Duration delay, blocks::SyncReaction reaction) {
  delay_ = delay;
  reaction_ = reaction;
  if (reaction == blocks::SyncReaction::None) fire(Event::Released);
}

void SyncGuard::stop(Event event) {
  is_active_ = is_due_ = pauses_ = false;
  since_.reset();
  fire(event);
}

void SyncGuard::fire(Event event) {
  const auto row = findTransition<SyncGuardTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  if (row->action == SyncGuardAction::HoldAgain) pauses_ = true;
  if (row->action == SyncGuardAction::Interrupt) pauses_ = moves_;
  if (row->action == SyncGuardAction::Tell || row->action == SyncGuardAction::Interrupt) tells_ = true;
}

void SyncGuard::look(const Seen& seen, Instant now) {
  if (!is_active_) return;
  moves_ = seen.moves;
  if (!seen.robot_enabled) operates_ = false;
  if (!seen.judged) return;
  if (seen.in_sync) {
    operates_ = seen.robot_enabled;
    since_.reset();
    is_due_ = false;
    fire(Event::InSync);
    return;
  }
  if (!since_) since_ = now;
  is_due_ = isDue(now);
  if (is_due_) react(seen);
}

void SyncGuard::react(const Seen& seen) {
  if (reaction_ == blocks::SyncReaction::None) return;
  fire(Event::OutOfSync);
  if (!operates_) {
    fire(Event::NoEnable);
  } else if (reaction_ == blocks::SyncReaction::InterruptWhenEmpty) {
    fire(seen.anything_there ? Event::WhenEmpty : Event::Interrupt);
  } else if (reaction_ == blocks::SyncReaction::InterruptAtOnce) {
    fire(Event::Interrupt);
  }
}

bool SyncGuard::interrupts() const {
  return state_ == State::Interrupted || state_ == State::Stopped || state_ == State::Resumable;
}

std::optional<Instant> SyncGuard::nextDeadline() const {
  return since_ && !is_due_ ? std::optional(*since_ + delay_) : std::nullopt;
}

}  // namespace cobot_command::command
