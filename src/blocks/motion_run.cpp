#include "motion_run.h"

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {

using Event = MotionRunEvent;
using State = MotionRunState;

namespace {

Duration timeFor(const MotionOrder& order, const link::LinkSettings& settings) {
  if (!order.plan) return settings.unplanned_motion_timeout;
  return order.plan->start_delay +
         fromSeconds(toSeconds(order.plan->duration) * settings.tag_deadline_factor) +
         settings.tag_deadline_margin;
}

}  // namespace

MotionRun::MotionRun(MotionOrder order, const RunContext& context, Instant now)
    : order_(std::move(order)),
      context_(context),
      sent_at_(now),
      give_up_at_(now + context.settings.unplanned_motion_timeout) {
  context_.board.accept(order_.block, order_.goal, order_.command_id_ack);
  script_id_ = context_.link.sendScript(protocol::toText(order_.script), now);
  report(Phase::Sent, "sent to the controller");
}

void MotionRun::cancel(Instant now) {
  fire(Event::Cancel, now);
}

void MotionRun::abandon(const std::string& why, Instant now) {
  if (ended()) return;
  if (state_ != State::Stopping && state_ != State::Settling) sendStop(now);
  state_ = State::Ended;
  Outcome outcome;
  outcome.ending = Ending::CommandAborted;
  outcome.error_description = why;
  end(std::move(outcome), now);
}

void MotionRun::tagCompleted(Instant now) {
  fire(Event::TagComplete, now);
}

void MotionRun::advance(Instant now) {
  becomeActiveWhenDue(now);
  if (!deadline_ || now < *deadline_ || held_since_) return;
  if (state_ == State::Executing) {
    fire(Event::Overdue, now);
  } else if (state_ == State::Settling) {
    if (context_.robot.moving().value_or(false)) {
      fail({own_error::kStopNotConfirmed, "the robot still moves after the accepted stop", ""},
           Robot::LeaveIt, now);
    } else {
      fire(Event::Standing, now);
    }
  }
}

std::optional<Instant> MotionRun::nextDeadline() const {
  if (held_since_) return std::nullopt;
  if (phase_ == Phase::Queued && active_at_ && (!deadline_ || *active_at_ < *deadline_)) return active_at_;
  return deadline_;
}

void MotionRun::robotChanged(Instant now) {
  if (ended()) return;
  if (context_.robot.emergencyStop()) {
    fail({motion_error::kLinkDropped, "emergency stop",
          "Release the emergency stop and start the project again"},
         Robot::Stop, now);
    return;
  }
  if (context_.robot.inError()) {
    fail({own_error::kRobotError, context_.robot.errorText(), ""}, Robot::Stop, now);
    return;
  }
  followHold(now);
  if (state_ == State::Settling && context_.robot.moving() == false) fire(Event::Standing, now);
}

void MotionRun::linkLost(const std::string& reason, Instant now) {
  fail({motion_error::kLinkDropped, reason, ""}, Robot::LeaveIt, now);
}

/// A paused robot gets the time back that the pause took.
void MotionRun::followHold(Instant now) {
  const bool stopping = state_ == State::Stopping || state_ == State::Settling;
  const bool held = context_.robot.held() && !stopping;
  if (held && !held_since_) {
    held_since_ = now;
  } else if (!held && held_since_) {
    const Duration pause = now - *held_since_;
    held_since_.reset();
    if (deadline_ && state_ == State::Executing) *deadline_ += pause;
    if (active_at_) *active_at_ += pause;
    give_up_at_ += pause;
  }
}

void MotionRun::fire(Event event, Instant now) {
  const auto row = link::findTransition<MotionRunTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void MotionRun::fail(Failure failure, Robot robot, Instant now) {
  failure_ = std::move(failure);
  robot_on_failure_ = robot;
  fire(Event::Failed, now);
}

void MotionRun::act(MotionRunAction action, Instant now) {
  using Do = MotionRunAction;
  switch (action) {
    case Do::None:
      return;
    case Do::RememberTag:
      tag_seen_at_ = now;
      return;
    case Do::AwaitTag:
      awaitTag(now);
      return;
    case Do::AskTag:
      deadline_.reset();
      context_.link.queryTag(*order_.tag, now);
      return;
    case Do::Extend:
      deadline_ = now + context_.settings.tag_deadline_margin;
      return;
    case Do::SendStop:
      report(Phase::Stopping, "cancelled, stopping the robot");
      sendStop(now);
      return;
    case Do::AwaitStandstill:
      awaitStandstill(now);
      return;
    case Do::EndDone:
      end(Outcome{}, now);
      return;
    case Do::EndError:
      if (robot_on_failure_ == Robot::Stop) sendStop(now);
      end(toOutcome(order_.block, Ending::Aborted, failure_), now);
      return;
    case Do::EndAborted: {
      Outcome outcome;
      outcome.ending = Ending::CommandAborted;
      outcome.error_description = "cancelled; the robot was stopped";
      end(std::move(outcome), now);
      return;
    }
  }
}

void MotionRun::awaitTag(Instant now) {
  accepted_at_ = now;
  deadline_ = now + timeFor(order_, context_.settings);
  if (order_.plan && order_.plan->start_delay > Duration::zero()) {
    active_at_ = now + order_.plan->start_delay;
    report(Phase::Queued, "accepted, waits for the motion in front of it");
  } else {
    report(Phase::Active, "the robot moves");
  }
}

void MotionRun::becomeActiveWhenDue(Instant now) {
  const bool waits = phase_ == Phase::Queued && (state_ == State::Executing || state_ == State::Confirming);
  if (waits && active_at_ && now >= *active_at_ && !held_since_) report(Phase::Active, "the robot moves");
}

void MotionRun::awaitStandstill(Instant now) {
  deadline_ = now + context_.settings.stop_timeout;
  // Without a stream that tells of joint speeds, the accepted stop is all that can be known.
  if (!context_.robot.moving()) fire(Event::Standing, now);
}

/// Whatever was queued before is dropped, and its tags mean nothing any more.
void MotionRun::sendStop(Instant now) {
  deadline_.reset();
  active_at_.reset();
  held_since_.reset();
  context_.tags.renewEpoch();
  if (!context_.link.established()) return;
  stop_id_ = context_.link.sendScript(
      protocol::toText(protocol::ScriptCommand(protocol::StopAndClearBuffer{})), now);
}

void MotionRun::report(Phase phase, std::string text) {
  phase_ = phase;
  Progress progress;
  progress.phase = phase;
  progress.command_id_ack = order_.command_id_ack;
  if (order_.plan) progress.planned = order_.plan->duration;
  progress.text = std::move(text);
  context_.board.progress(order_.block, order_.goal, std::move(progress));
}

void MotionRun::end(Outcome outcome, Instant now) {
  deadline_.reset();
  if (order_.tag) context_.tags.abandon(*order_.tag);
  outcome.command_id_ack = order_.command_id_ack;
  if (order_.plan) outcome.planned = order_.plan->duration;
  if (tag_seen_at_) {
    outcome.actual = *tag_seen_at_ - sent_at_;
  } else if (accepted_at_) {
    outcome.actual = now - *accepted_at_;
  }
  outcome.final_joints_deg = context_.robot.jointsDeg();
  outcome.final_pose_mm_deg = context_.robot.toolInBaseMmDeg();
  context_.board.end(order_.block, order_.goal, std::move(outcome));
}

}  // namespace cobot_command::blocks
