#include "runs/command_run.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::command {

using Event = CommandRunEvent;
using State = CommandRunState;

namespace {

Duration timeFor(const CommandOrder& order, const link::LinkSettings& settings) {
  if (!order.plan) return settings.unplanned_motion_timeout;
  return order.plan->start_delay +
         fromSeconds(toSeconds(order.plan->duration) * settings.tag_deadline_factor) +
         settings.tag_deadline_margin;
}

/// "..., held by ...: what continues it".
std::string holdText(const robot::RobotWatch& robot, const CommandOrder& order, bool waits) {
  constexpr const char* kResume = "program_control with RESUME, or the pendant, continues it";
  const char* in_front = waits ? "waits for the motion in front of it, " : "";
  if (!robot.paused()) {
    return fmt::format("{}held by a safeguard: it goes on when that is released", in_front);
  }
  return fmt::format("{}{}: {}", in_front,
                     order.pauses ? "held by a Pause() in the script" : "held, the project is paused",
                     kResume);
}

std::optional<Duration> plannedTime(const CommandOrder& order) {
  return order.plan ? std::make_optional(order.plan->duration) : std::nullopt;
}

}  // namespace

CommandRun::CommandRun(CommandOrder order, const RunContext& context, Instant now)
    : order_(std::move(order)),
      context_(context),
      sent_at_(now),
      clock_(now, context.settings.unplanned_motion_timeout),
      evidence_(context.robot, context.settings, context.arm, order_.target),
      reports_(order_.command_id_ack, plannedTime(order_)),
      stop_in_front_(context.stop.last()) {
  script_id_ =
      context_.link.sendScript(fmt::format("{}", fmt::join(order_.lines, "\r\n")), now, order_.reply_timeout);
  tell(blocks::Phase::Sent, "sent to the controller", now);
}

void CommandRun::cancel(const std::string& why, Instant now) {
  if (!order_.moves || !mayBeCancelled()) return;
  cancelled_why_ = why;
  fire(Event::Cancel, now);
}

std::optional<std::size_t> CommandRun::markOf(int tag) const {
  const auto& marks = order_.mark_tags;
  const auto found = std::find(marks.begin() + static_cast<std::ptrdiff_t>(passed_), marks.end(), tag);
  if (found == marks.end()) return std::nullopt;
  return static_cast<std::size_t>(found - marks.begin());
}

void CommandRun::passMark(std::size_t mark) {
  while (passed_ < mark) context_.tags.abandon(order_.mark_tags[passed_++]);
  passed_ = mark + 1;
}

bool CommandRun::mayBeCancelled() const {
  return findTransition<CommandRunTable>(state_, Event::Cancel).has_value();
}

void CommandRun::abandon(const std::string& why, Instant now) {
  if (ended()) return;
  const bool told_to_stop = state_ == State::Stopping || state_ == State::Explaining;
  if (order_.moves && !told_to_stop) askForStop(now);
  state_ = State::Ended;
  end(blocks::commandAborted(why), now);
}

void CommandRun::tagCompleted(bool followed, Instant now) {
  followed_ = followed;
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
  if (clock_.beginsNow(now)) goOn(now);
  if (clock_.overdue(now)) fire(Event::Overdue, now);
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
  if (underWay() && order_.tag) evidence_.watch(now);
  if (state_ == State::Executing && order_.tag && evidence_.stalledOnTheWay()) fire(Event::Stalled, now);
  if (state_ == State::Verifying) verify(now);
  if (state_ == State::Explaining) lookForReason(now);
  if (reports_.due(now)) goOn(now);
}

void CommandRun::linkLost(const std::string& reason, Instant now) {
  fail({blocks::motion_error::kLinkDropped, reason, ""}, Robot::LeaveIt, now, Event::Unexplained);
}

/// A paused robot gets the time back that the pause took.
void CommandRun::followHold(Instant now) {
  const blocks::Phase phase = reports_.phase();
  if (underWay() && context_.robot.held()) {
    clock_.hold(now);
    if (phase == blocks::Phase::Active || phase == blocks::Phase::Queued) {
      tell(blocks::Phase::Held, holdText(context_.robot, order_, phase == blocks::Phase::Queued), now);
    }
  } else if (clock_.held()) {
    clock_.release(now);
    if (phase == blocks::Phase::Held) goOn(now);
  }
}

bool CommandRun::underWay() const {
  return state_ == State::Sent || state_ == State::Executing || state_ == State::Confirming;
}

void CommandRun::goOn(Instant now) {
  if (!clock_.mayExecute(now)) {
    tell(blocks::Phase::Queued, "accepted, waits for the motion in front of it", now);
    return;
  }
  clock_.execute(now);
  const bool unseen = order_.pauses && !context_.robot.tellsPause();
  tell(blocks::Phase::Active,
       unseen ? "the robot executes it; the Pause() in the script, which the status stream does not show, "
                "lasts until program_control with RESUME, or the pendant, continues it"
              : "the robot executes it",
       now);
}

void CommandRun::tell(blocks::Phase phase, std::string text, Instant now) {
  reports_.tell(phase, std::move(text), clock_.executed(now), now);
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
      clock_.goOn(now + context_.settings.tag_deadline_margin);
      evidence_.lookedInto();
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
      tell(blocks::Phase::Stopping, cancelled_why_ + ", stopping the robot", now);
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
      end(blocks::commandAborted(fmt::format("{}; {}", cancelled_why_, stopped_how_)), now);
      return;
  }
}

void CommandRun::awaitTag(Instant now) {
  clock_.expect(now, order_.plan ? order_.plan->start_delay : Duration::zero(),
                timeFor(order_, context_.settings));
  goOn(now);
  followHold(now);
}

void CommandRun::askTag(bool early, Instant now) {
  clock_.ask(early);
  context_.link.queryTag(*order_.tag, now);
}

/// What several commands need in one event is one stop.
void CommandRun::askForStop(Instant now) {
  clock_.clear();
  const bool is_asked = context_.stop.last() > stop_in_front_ && context_.stop.lastAt() == now;
  if (!is_asked) context_.stop.ask(order_.target, now);
  stop_ = context_.stop.last();
}

// --- Whether it is really done, and why not.

void CommandRun::beginVerifying(Instant now) {
  if (!tag_seen_at_) tag_seen_at_ = now;
  clock_.clear();  // its time begins with the first frame behind the tag
  if (followed_ || !order_.stands_at_end || !context_.robot.tellsMotion()) fire(Event::Verified, now);
}

void CommandRun::verify(Instant now) {
  if (evidence_.confirms()) {
    fire(Event::Verified, now);
  } else if (!clock_.hasDeadline()) {
    clock_.setDeadline(now + context_.settings.evidence_timeout);
  }
}

void CommandRun::judge(Instant now) {
  switch (evidence_.verdict()) {
    case Evidence::Verdict::Confirmed:
      return fire(Event::Verified, now);
    case Evidence::Verdict::Open:
      return clock_.setDeadline(now + context_.settings.evidence_timeout);
    case Evidence::Verdict::Contradicted:
      return fail({blocks::own_error::kNotAtTarget, evidence_.contradiction(*order_.tag), ""}, Robot::Stop,
                  now);
  }
}

void CommandRun::awaitReason(Instant now) {
  if (robot_on_failure_ == Robot::Stop) askForStop(now);
  robot_on_failure_ = Robot::LeaveIt;
  reason_.begin(now);
  clock_.clear();
  clock_.setDeadline(now + context_.settings.evidence_timeout);
  if (!context_.robot.status()) {
    fire(Event::Overdue, now);
    return;
  }
  // It does not execute any more: a stop may go on beside it, on a link that is there again.
  tell(blocks::Phase::Stopping, robot::ReasonWait::text("failed, " + failure_.found), now);
}

/// An error that was acknowledged, and is still there when the next motion fails, is the reason for that.
void CommandRun::lookForReason(Instant now) {
  if (context_.robot.showsError() && !order_.beside) {
    fail(blocks::robotError(context_.robot), Robot::LeaveIt, now);
    return;
  }
  if (context_.robot.status() && !reason_.endsWithFrame(now)) return;
  if (failure_.error_id == blocks::motion_error::kLinkDropped) {
    blocks::tellStoppedProject(context_.robot, failure_);
  }
  fire(Event::Overdue, now);
}

void CommandRun::end(blocks::Outcome outcome, Instant now) {
  clock_.clear();
  if (order_.tag && !tag_seen_at_) context_.tags.abandon(*order_.tag);
  for (std::size_t i = passed_; i < order_.mark_tags.size(); ++i) context_.tags.abandon(order_.mark_tags[i]);
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
