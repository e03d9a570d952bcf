#include "waits/queue_wait.h"

#include <algorithm>
#include <utility>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::blocks {

void QueueWait::begin(std::optional<Duration> time, Instant now) {
  began_at_ = now;
  if (time) deadline_ = now + *time;
  tell(now);
}

std::optional<Duration> QueueWait::remaining(Instant now) const {
  if (!deadline_) return std::nullopt;
  return std::max(Duration::zero(), *deadline_ - held_since_.value_or(now));
}

void QueueWait::cancel(const std::string& why, Instant now) {
  words_ = why + " while it waited for " + name();
  fire(Event::Cancelled, now);
}

void QueueWait::finish(FinishAfter after, Instant now) {
  if (after != FinishAfter::Move) return;
  words_ = "finished on request, while it waited for " + name();
  fire(Event::Cancelled, now);
}

void QueueWait::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  failure_ = {motion_error::kLinkDropped, reason, ""};
  if (patience) deadline_ = now + *patience;
  fire(patience ? Event::Unexplained : Event::Failed, now);
}

void QueueWait::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (robot.emergencyStop()) {
    fail(emergencyStop(), now);
  } else if (robot.inError()) {
    fail(robotError(robot), now);
  } else if (state_ == State::Explaining) {
    tellStoppedProject(robot, failure_);
    if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
  } else if (state_ == State::Waiting) {
    look(robot, now);
  }
}

void QueueWait::advance(Instant now) {
  if (!nextDeadline() || now < *deadline_) return;
  if (state_ == State::Waiting) {
    timeIsOver(now);
  } else {
    fire(Event::Failed, now);
  }
}

std::optional<Instant> QueueWait::nextDeadline() const {
  return state_ == State::Ended || held_since_ ? std::nullopt : deadline_;
}

void QueueWait::followHold(bool held, Instant now) {
  if (held && !held_since_) {
    held_since_ = now;
    tell(now);
  } else if (!held && held_since_) {
    if (deadline_) *deadline_ += now - *held_since_;
    held_since_.reset();
    tell(now);
  }
}

void QueueWait::tell(Instant now) {
  Progress told = progress(now);
  told.phase = held_since_ ? Phase::Held : Phase::Active;
  told_at_ = now;
  report(std::move(told));
}

void QueueWait::fail(Failure failure, Instant now) {
  failure_ = std::move(failure);
  fire(Event::Failed, now);
}

void QueueWait::fire(Event event, Instant now) {
  const auto row = findTransition<QueueWaitTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case QueueWaitAction::None:
      return;
    case QueueWaitAction::AwaitReason: {
      held_since_.reset();
      reason_.begin(now);
      Progress told;
      told.phase = Phase::Stopping;
      told.text = robot::ReasonWait::text("failed, " + failure_.found);
      report(std::move(told));
      return;
    }
    case QueueWaitAction::EndDone:
      endWith({}, now);
      return;
    case QueueWaitAction::EndError:
      endWith(toOutcome(block(), Ending::Aborted, failure_), now);
      return;
    case QueueWaitAction::EndAborted:
      endWith(commandAborted(words_), now);
      return;
  }
}

void QueueWait::endWith(Outcome outcome, Instant now) {
  outcome.actual = now - began_at_;
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
