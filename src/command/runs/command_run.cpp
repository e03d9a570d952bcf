#include "runs/command_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::command {

using Event = CommandRunEvent;
using State = CommandRunState;

namespace {

Duration timeFor(const CommandOrder& order, const link::LinkSettings& settings) {
  if (!order.plan || order.is_open_ended) return settings.unplanned_motion_timeout;
  return order.plan->start_delay +
         fromSeconds(toSeconds(order.plan->duration) * settings.tag_deadline_factor) +
         settings.tag_deadline_margin;
}

Duration timeForEvidence(const CommandOrder& order, const link::LinkSettings& settings) {
  return order.evidence_timeout.value_or(settings.evidence_timeout);
}

}  // namespace

CommandRun::CommandRun(CommandOrder order, const RunContext& context, Instant now)
    : order_(std::move(order)),
      context_(context),
      sent_at_(now),
      clock_(now, context.settings.unplanned_motion_timeout),
      evidence_(context.robot, context.settings, context.arm, order_.target),
      reports_(order_, context.robot, clock_, context.arm),
      stop_in_front_(context.stop.last()) {
  script_id_ =
      context_.link.sendScript(fmt::format("{}", fmt::join(order_.lines, "\r\n")), now, order_.reply_timeout);
  reports_.tell(blocks::Phase::Sent, "sent to the controller", now);
}

void CommandRun::cancel(const std::string& why, Instant now) {
  if (!order_.moves || !mayBeCancelled()) return;
  cancelled_why_ = why;
  fire(Event::Cancel, now);
}

std::size_t CommandRun::passMark(int tag) {
  auto& marks = order_.mark_tags;
  const auto passed = std::find(marks.begin(), marks.end(), tag);
  for (auto mark = marks.begin(); mark != passed; ++mark) context_.tags.abandon(std::exchange(*mark, 0));
  *passed = 0;
  return static_cast<std::size_t>(passed - marks.begin());
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
  if (clock_.beginsNow(now)) reports_.goOn(now);
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
  reports_.followHold(underWay(), now);
  if (underWay() && order_.tag) evidence_.watch(now);
  if (state_ == State::Executing && order_.tag && evidence_.stalledOnTheWay()) fire(Event::Stalled, now);
  if (state_ == State::Verifying) verify(now);
  if (state_ == State::Explaining) lookForReason(now);
  if (reports_.due(now)) reports_.goOn(now);
}

void CommandRun::linkLost(const std::string& reason, Instant now) {
  fail({blocks::motion_error::kLinkDropped, reason, ""}, Robot::LeaveIt, now, Event::Unexplained);
}

bool CommandRun::underWay() const {
  return state_ == State::Sent || state_ == State::Executing || state_ == State::Confirming;
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
      clock_.ask(action == Do::AskTagEarly);
      if (action == Do::AskTag) asked_at_ = asked_at_.value_or(now);
      context_.link.queryTag(*order_.tag, now);
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
      reports_.tell(blocks::Phase::Stopping, cancelled_why_ + ", stopping the robot", now);
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
  reports_.goOn(now);
  reports_.followHold(underWay(), now);
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
  is_to_be_seen_ = order_.moves && order_.stands_at_end && !followed_;
  if (!is_to_be_seen_ || !context_.robot.tellsMotion()) fire(Event::Verified, now);
}

void CommandRun::verify(Instant now) {
  if (evidence_.confirms()) {
    fire(Event::Verified, now);
  } else if (!clock_.hasDeadline()) {
    clock_.setDeadline(now + timeForEvidence(order_, context_.settings));
  }
}

void CommandRun::judge(Instant now) {
  switch (evidence_.verdict()) {
    case Evidence::Verdict::Confirmed:
      return fire(Event::Verified, now);
    case Evidence::Verdict::Open:
      return clock_.setDeadline(now + timeForEvidence(order_, context_.settings));
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
  reports_.tell(blocks::Phase::Stopping, robot::ReasonWait::text("failed, " + failure_.found), now);
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

// --- How fast it is made.

void CommandRun::retime(const Origin& origin, Plan plan) {
  if (!underWay()) return;
  const Duration before = timeFor(order_, context_.settings);
  const auto percent = [](const Origin& from) { return std::round(100 * from.start.speed_override); };
  remarks_.pace = fmt::format(
      "planned for {:.2f} s at the project speed of {} %, and for {:.2f} s at {} %, which "
      "the status stream showed when it began",
      toSeconds(order_.plan->duration), percent(*order_.origin), toSeconds(plan.duration), percent(origin));
  order_.plan = std::move(plan);
  order_.origin = origin;
  clock_.prolong(timeFor(order_, context_.settings) - before);
}

void CommandRun::end(blocks::Outcome outcome, Instant now) {
  clock_.clear();
  if (order_.tag && !tag_seen_at_) context_.tags.abandon(*order_.tag);
  for (const int mark : order_.mark_tags) context_.tags.abandon(mark);
  outcome.command_id_ack = order_.command_id_ack;
  if (order_.plan) outcome.planned = order_.plan->duration;
  if (tag_seen_at_) {
    outcome.actual =
        *tag_seen_at_ - (accepted_at_ && *accepted_at_ < *tag_seen_at_ ? *accepted_at_ : sent_at_);
  } else if (accepted_at_ && order_.tag) {
    outcome.actual = now - *accepted_at_;
  }
  const bool is_done = outcome.ending == blocks::Ending::Done;
  const robot::StreamedPlace place = is_done ? evidence_.place() : context_.robot.place();
  if (is_done && is_to_be_seen_) remarks_.unseen = evidence_.whyUnseen();
  remarks_.unplanned = order_.unplanned;
  outcome.remarks = std::move(remarks_);
  outcome.final_joints_deg = place.joints_deg;
  outcome.final_pose_mm_deg = place.tool_in_base_mm_deg;
  outcome_ = std::move(outcome);
}

}  // namespace cobot_command::command
