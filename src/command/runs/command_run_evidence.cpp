// What the status stream has to say before a command ends: that the robot is where its tag says, or why it is
// not.

#include "runs/command_run.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::command {

using Event = CommandRunEvent;
using State = CommandRunState;

/// A stop by somebody else is reported to nobody. But the robot then stands away from the target, and the
/// controller, asked, no longer knows the tag. The question alone changes nothing, so it needs no certainty.
void CommandRun::watchForStall(Instant now) {
  if (!underWay() || !order_.tag) return;
  stall_.see(context_.robot, now);
  if (state_ != State::Executing || !stall_.stalled(context_.settings.evidence_timeout)) return;
  const auto to_go = gap();
  if (!to_go || !to_go->closed) fire(Event::Stalled, now);
}

std::string CommandRun::stallText() const {
  const auto to_go = gap();
  return fmt::format(
      "the robot stands{}, nothing holds it, and the controller does not know tag {} any more: "
      "another client or the project has stopped the robot",
      to_go ? ", " + to_go->text : "", *order_.tag);
}

void CommandRun::beginVerifying(Instant now) {
  if (!tag_seen_at_) tag_seen_at_ = now;
  deadline_.reset();  // it begins with the first frame behind the tag
  active_at_.reset();
  held_since_.reset();
  reached_ = false;
  if (!order_.stands_at_end || !context_.robot.tellsMotion()) fire(Event::Verified, now);
}

std::optional<robot::Gap> CommandRun::gap() const {
  const auto& status = context_.robot.status();
  if (!status || !order_.target) return std::nullopt;
  return robot::gapTo(*order_.target, *status, context_.arm,
                      {context_.settings.position_tolerance, context_.settings.angle_tolerance});
}

/// With each frame behind the tag. The first ones may be of before the tag.
void CommandRun::verify(Instant now) {
  if (!context_.robot.tellsMotion()) {  // the stream stopped: the tag is all that is known
    fire(Event::Verified, now);
    return;
  }
  if (!deadline_) deadline_ = now + context_.settings.evidence_timeout;
  const auto to_go = gap();
  if (to_go && !to_go->closed) return;
  if (context_.robot.moving() == false) {
    fire(Event::Verified, now);
  } else if (to_go && !order_.target->is_the_start) {
    reached_ = true;
  }
}

/// It was at its target, and moves on at once: that is another client's motion, and none of this goal's
/// business.
void CommandRun::judge(Instant now) {
  const auto to_go = gap();
  const bool away = to_go && !to_go->closed;
  if (reached_) {
    fire(Event::Verified, now);
    return;
  }
  if (!away && !context_.robot.moving()) {  // a slow stream: a few more frames tell it
    deadline_ = now + context_.settings.evidence_timeout;
    return;
  }
  fail({blocks::own_error::kNotAtTarget,
        fmt::format("tag {} was reported complete, but {}", *order_.tag,
                    away ? to_go->text : "the robot still moves"),
        ""},
       Robot::Stop, now);
}

void CommandRun::awaitReason(Instant now) {
  if (robot_on_failure_ == Robot::Stop) askForStop(now);
  robot_on_failure_ = Robot::LeaveIt;
  reason_.begin(now);
  deadline_ = now + context_.settings.evidence_timeout;
  active_at_.reset();
  held_since_.reset();
  if (!context_.robot.status()) {
    fire(Event::Overdue, now);
    return;
  }
  // It does not execute any more: a stop may go on beside it, on a link that is there again.
  report(blocks::Phase::Stopping, robot::ReasonWait::text("failed, " + failure_.found), now);
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

}  // namespace cobot_command::command
