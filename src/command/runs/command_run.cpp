#include "runs/command_run.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::command {

using Event = CommandRunEvent;
using State = CommandRunState;

namespace {

/// Between two reports of the progress of a motion.
constexpr Duration kReportPeriod = std::chrono::milliseconds(100);
/// The end of a motion is told by its tag, not by the clock.
constexpr double kNearlyDone = 0.99;
constexpr const char* kBehindAnother = "accepted, waits for the motion in front of it";

Duration timeFor(const CommandOrder& order, const link::LinkSettings& settings) {
  if (!order.plan) return settings.unplanned_motion_timeout;
  return order.plan->start_delay +
         fromSeconds(toSeconds(order.plan->duration) * settings.tag_deadline_factor) +
         settings.tag_deadline_margin;
}

}  // namespace

CommandRun::CommandRun(CommandOrder order, const RunContext& context, Instant now)
    : order_(std::move(order)),
      context_(context),
      sent_at_(now),
      give_up_at_(now + context.settings.unplanned_motion_timeout),
      reported_at_(now) {
  script_id_ =
      context_.link.sendScript(fmt::format("{}", fmt::join(order_.lines, "\r\n")), now, order_.reply_timeout);
  report(blocks::Phase::Sent, "sent to the controller", now);
}

void CommandRun::cancel(const std::string& why, Instant now) {
  if (!order_.moves || !mayBeCancelled()) return;
  cancelled_why_ = why;
  fire(Event::Cancel, now);
}

bool CommandRun::mayBeCancelled() const {
  return findTransition<CommandRunTable>(state_, Event::Cancel).has_value();
}

void CommandRun::abandon(const std::string& why, Instant now) {
  if (ended()) return;
  const bool told_to_stop = state_ == State::Stopping || state_ == State::Explaining;
  if (order_.moves && !told_to_stop) askForStop(now);
  state_ = State::Ended;
  endAborted(why, now);
}

void CommandRun::endAborted(const std::string& why, Instant now) {
  end(blocks::commandAborted(why), now);
}

void CommandRun::tagCompleted(Instant now) {
  fire(Event::TagComplete, now);
}

void CommandRun::stopEnded(const StopRun::Result& result, Instant now) {
  if (state_ != State::Stopping || result.number != stop_) return;
  if (result.failed()) {
    fail(result.failure, Robot::LeaveIt, now);
  } else {
    stopped_how_ = result.words();
    fire(Event::Stopped, now);
  }
}

void CommandRun::advance(Instant now) {
  becomeActiveWhenDue(now);
  if (deadline_ && now >= *deadline_ && !held_since_) fire(Event::Overdue, now);
}

std::optional<Instant> CommandRun::nextDeadline() const {
  if (held_since_) return std::nullopt;
  return phase_ == blocks::Phase::Queued ? earlier(active_at_, deadline_) : deadline_;
}

void CommandRun::robotChanged(Instant now) {
  if (ended()) return;
  if (context_.robot.emergencyStop()) {
    fail(blocks::emergencyStop(), order_.beside ? Robot::LeaveIt : Robot::Stop, now);
    return;
  }
  if (context_.robot.inError() && !order_.beside) {
    fail(blocks::robotError(context_.robot), Robot::Stop, now);
    return;
  }
  followHold(now);
  watchForStall(now);
  if (state_ == State::Verifying) verify(now);
  if (state_ == State::Explaining) lookForReason(now);
  if (phase_ == blocks::Phase::Active && now - reported_at_ >= kReportPeriod) becomeActive(now);
}

void CommandRun::linkLost(const std::string& reason, Instant now) {
  fail({blocks::motion_error::kLinkDropped, reason, ""}, Robot::LeaveIt, now, Event::Unexplained);
}

/// A paused robot gets the time back that the pause took.
void CommandRun::followHold(Instant now) {
  const bool held = underWay() && context_.robot.held();
  if (held) {
    if (!held_since_) held_since_ = now;
    if (phase_ == blocks::Phase::Active || phase_ == blocks::Phase::Queued) {
      report(blocks::Phase::Held, holdText(), now);
    }
  } else if (held_since_) {
    const Duration pause = now - *held_since_;
    held_since_.reset();
    if (deadline_) *deadline_ += pause;
    if (due_) *due_ += pause;
    if (active_at_) *active_at_ += pause;
    if (moving_from_) *moving_from_ += pause;
    give_up_at_ += pause;
    if (phase_ == blocks::Phase::Held) goOn(now);
  }
}

bool CommandRun::underWay() const {
  return state_ == State::Sent || state_ == State::Executing || state_ == State::Confirming;
}

void CommandRun::goOn(Instant now) {
  if (moving_from_ || !active_at_ || now >= *active_at_) {
    becomeActive(now);
  } else {
    report(blocks::Phase::Queued, kBehindAnother, now);
  }
}

std::string CommandRun::holdText() const {
  constexpr const char* kResume = "program_control with RESUME, or the pendant, continues it";
  const char* in_front = phase_ == blocks::Phase::Queued ? "waits for the motion in front of it, " : "";
  if (!context_.robot.paused()) {
    return fmt::format("{}held by a safeguard: it goes on when that is released", in_front);
  }
  return fmt::format("{}{}: {}", in_front,
                     order_.pauses ? "held by a Pause() in the script" : "held, the project is paused",
                     kResume);
}

void CommandRun::fire(Event event, Instant now) {
  const auto row = findTransition<CommandRunTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void CommandRun::fail(blocks::Failure failure, Robot robot, Instant now, Event event) {
  if (!findTransition<CommandRunTable>(state_, event)) return;
  failure_ = std::move(failure);
  if (state_ != State::Explaining) robot_on_failure_ = robot;  // there it was done when it failed
  fire(event, now);
}

void CommandRun::act(CommandRunAction action, Instant now) {
  using Do = CommandRunAction;
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
    case Do::AskTagEarly:
      askTag(action == Do::AskTagEarly, now);
      return;
    case Do::Extend:
      extend(now);
      return;
    case Do::Verify:
      beginVerifying(now);
      return;
    case Do::Judge:
      judge(now);
      return;
    case Do::AwaitReason:
      awaitReason(now);
      return;
    case Do::AskForStop:
      report(blocks::Phase::Stopping, cancelled_why_ + ", stopping the robot", now);
      askForStop(now);
      return;
    case Do::EndDone:
      end(blocks::Outcome{}, now);
      return;
    case Do::EndError:
      if (robot_on_failure_ == Robot::Stop) askForStop(now);
      end(blocks::toOutcome(order_.block, blocks::Ending::Aborted, failure_), now);
      return;
    case Do::EndAborted:
      endAborted(fmt::format("{}; {}", cancelled_why_, stopped_how_), now);
      return;
  }
}

void CommandRun::awaitTag(Instant now) {
  if (held_since_) held_since_ = now;  // what follows begins now, and is held from now on
  deadline_ = now + timeFor(order_, context_.settings);
  if (order_.plan && order_.plan->start_delay > Duration::zero()) {
    active_at_ = now + order_.plan->start_delay;
    report(blocks::Phase::Queued, kBehindAnother, now);
  } else {
    becomeActive(now);
  }
  followHold(now);
}

void CommandRun::askTag(bool early, Instant now) {
  due_ = early ? deadline_ : std::nullopt;
  deadline_.reset();
  context_.link.queryTag(*order_.tag, now);
}

void CommandRun::extend(Instant now) {
  deadline_ = due_.value_or(now + context_.settings.tag_deadline_margin);
  due_.reset();
  stall_.lookedInto();
}

void CommandRun::becomeActiveWhenDue(Instant now) {
  const bool waits =
      phase_ == blocks::Phase::Queued && (state_ == State::Executing || state_ == State::Confirming);
  if (waits && active_at_ && now >= *active_at_ && !held_since_) becomeActive(now);
}

void CommandRun::becomeActive(Instant now) {
  if (!moving_from_) moving_from_ = now;
  const bool unseen = order_.pauses && !context_.robot.tellsPause();
  report(blocks::Phase::Active,
         unseen ? "the robot executes it; the Pause() in the script, which the status stream does not show, "
                  "lasts until program_control with RESUME, or the pendant, continues it"
                : "the robot executes it",
         now);
}

void CommandRun::askForStop(Instant now) {
  deadline_.reset();
  active_at_.reset();
  held_since_.reset();
  context_.stop.ask(order_.target, now);
  stop_ = context_.stop.last();
}

void CommandRun::report(blocks::Phase phase, std::string text, Instant now) {
  phase_ = phase;
  reported_at_ = now;
  blocks::Progress progress;
  progress.phase = phase;
  progress.command_id_ack = order_.command_id_ack;
  progress.text = std::move(text);
  if (order_.plan) {
    const Duration passed = moving_from_ ? now - *moving_from_ : Duration::zero();
    const Duration whole = order_.plan->duration;
    progress.planned = whole;
    progress.remaining = std::max(Duration::zero(), whole - passed);
    if (moving_from_ && whole > Duration::zero()) {
      progress.fraction = std::clamp(toSeconds(passed) / toSeconds(whole), 0.0, kNearlyDone);
    }
  }
  progress_.push_back(std::move(progress));
}

std::vector<blocks::Progress> CommandRun::takeProgress() {
  return std::exchange(progress_, {});
}

void CommandRun::end(blocks::Outcome outcome, Instant now) {
  deadline_.reset();
  if (order_.tag) context_.tags.abandon(*order_.tag);
  outcome.command_id_ack = order_.command_id_ack;
  if (order_.plan) outcome.planned = order_.plan->duration;
  if (tag_seen_at_) {
    outcome.actual =
        *tag_seen_at_ - (accepted_at_ && *accepted_at_ < *tag_seen_at_ ? *accepted_at_ : sent_at_);
  } else if (accepted_at_ && order_.tag) {
    outcome.actual = now - *accepted_at_;
  }
  outcome.final_joints_deg = context_.robot.jointsDeg();
  outcome.final_pose_mm_deg = context_.robot.toolInBaseMmDeg();
  outcome_ = std::move(outcome);
}

}  // namespace cobot_command::command
