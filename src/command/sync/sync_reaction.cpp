#include "sync/sync_reaction.h"

namespace cobot_command::command {

void SyncReaction::begin(Duration delay, blocks::SyncReaction reaction) {
  is_active_ = true;
  operates_ = is_due_ = false;
  due_.reset();
  change(delay, reaction);
}

void SyncReaction::change(Duration delay, blocks::SyncReaction reaction) {
  delay_ = delay;
  reaction_ = reaction;
  if (reaction == blocks::SyncReaction::None) fire(Event::Released);
}

void SyncReaction::stop(Event event) {
  is_active_ = is_due_ = pauses_ = false;
  due_.reset();
  fire(event);
}

void SyncReaction::fire(Event event) {
  const auto row = findTransition<SyncReactionTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  if (row->action == SyncReactionAction::Tell) tells_ = true;
}

void SyncReaction::look(const Seen& seen, Instant now) {
  if (!is_active_) return;
  if (!seen.robot_enabled) operates_ = false;
  if (!seen.judged) return;
  if (seen.in_sync) {
    operates_ = seen.robot_enabled;
    is_due_ = false;
    due_.reset();
    fire(Event::InSync);
    return;
  }
  fire(Event::OutOfSync);
  if (!is_due_ && !due_) due_ = now + delay_;
  if (due_ && now >= *due_) {
    is_due_ = true;
    due_.reset();
  }
  if (is_due_) react(seen);
}

void SyncReaction::react(const Seen& seen) {
  using blocks::SyncReaction;
  if (reaction_ == SyncReaction::None) return;
  if (!operates_) {
    fire(Event::NoEnable);
  } else if (reaction_ == SyncReaction::InterruptWhenEmpty) {
    fire(seen.anything_there ? Event::WhenEmpty : Event::Interrupt);
  } else if (reaction_ == SyncReaction::InterruptAtOnce) {
    pauses_ = seen.anything_there && !interrupts();
    fire(Event::Interrupt);
  }
}

bool SyncReaction::interrupts() const {
  return state_ == State::Interrupted || state_ == State::Stopped || state_ == State::Resumable;
}

std::optional<Instant> SyncReaction::nextDeadline() const {
  return due_;
}

}  // namespace cobot_command::command
