#include "trajectory/trajectory_run.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

/// Twenty times a second.
constexpr Duration kTellEvery = std::chrono::milliseconds(50);

Failure blaming(Failure failure, int joint) {
  TrajectoryReport report;
  report.error_joint = joint;
  failure.detail = Detail(std::move(report));
  return failure;
}

}  // namespace

TrajectoryRun::TrajectoryRun(const FollowJointTrajectoryGoal& goal, GoalId id, const Outcome& planned,
                             Instant now)
    : Run(kBlock<FollowJointTrajectoryGoal>, id),
      plan_(planned.detail.as<TrajectoryReport>().plan),
      found_(planned) {
  traits_.awaits_motion = true;
  if (goal.goal_time_tolerance > 0) traits_.evidence_timeout = fromSeconds(goal.goal_time_tolerance);
  if (goal.starts_in > 0) starts_at_ = now + fromSeconds(goal.starts_in);
  if (!plan_->motion) fire(Event::Done, now);
}

// --- What is sent.

std::optional<Command> TrajectoryRun::next() const {
  if (state_ != State::Following || sent_ || starts_at_) return std::nullopt;
  Command command;
  command.block = block();
  command.traits = traits_;
  command.order = [plan = plan_](const arm::Pose& /*base*/) { return plan->order; };
  return command;
}

void TrajectoryRun::commandStarted(CommandKey /*key*/) {
  sent_ = true;
}

void TrajectoryRun::advance(Instant now) {
  if (starts_at_ && now >= *starts_at_) starts_at_.reset();
  if (reason_until_ && now >= *reason_until_) fire(Event::Failed, now);
}

std::optional<Instant> TrajectoryRun::nextDeadline() const {
  return earlier(state_ == State::Following ? starts_at_ : std::nullopt, reason_until_);
}

// --- What becomes of it.

void TrajectoryRun::commandProgressed(CommandKey /*key*/, const Progress& progress, Instant now) {
  progress_ = progress;
  if (progress.phase == Phase::Active && !follower_) {
    const Duration duration = plan_->motion->duration();
    const Duration planned = progress.planned.value_or(duration);
    follower_.emplace(plan_, planned > Duration::zero() ? toSeconds(duration) / toSeconds(planned) : 1.0,
                      now);
  }
  told_at_.reset();
  tell(now);
}

void TrajectoryRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant now) {
  found_ = outcome;
  ended_ = true;
  const bool is_elsewhere = isError(block(), outcome.error_id, own_error::kNotAtTarget);
  if (state_ != State::OffPath && (outcome.ending == Ending::Done || is_elsewhere)) {
    judgeEnd(now);
  } else if (outcome.ending == Ending::Aborted && state_ == State::OffPath) {
    // A robot that was off its path, and of which it is not known that it stands: both count.
    failure_.found += fmt::format("; then {} {}", errorNumber(outcome.error_id), outcome.error_description);
    fire(Event::NothingLeft, now);
  } else if (outcome.ending == Ending::Aborted) {
    fail(failureOf(block(), outcome), Event::Failed, now);
  } else {
    if (!outcome.error_description.empty()) stopped_why_ = outcome.error_description;
    fire(Event::Cancel, now);
    fire(Event::NothingLeft, now);
  }
}

/// By the frame that its command ended with: what moves the robot since then may be another client's motion.
void TrajectoryRun::judgeEnd(Instant now) {
  if (!found_.final_joints_deg) {
    fire(Event::Done, now);  // the tag is all that is known
    return;
  }
  const arm::JointVector joints = arm::toJointVector(*found_.final_joints_deg);
  const arm::JointVector gap = (plan_->motion->end().position - joints).cwiseAbs();
  Eigen::Index joint = 0;
  const bool is_off = gap.cwiseQuotient(plan_->goal_tolerance).maxCoeff(&joint) > 1.0;
  const bool moves = found_.ending != Ending::Done && moving_.value_or(false);
  if (!is_off && !moves) {
    fire(Event::Done, now);
    return;
  }
  const std::string where = fmt::format("J{} is {:.3f} deg from its goal; allowed: {:.3f} deg", joint + 1,
                                        radToDeg(gap[joint]), radToDeg(plan_->goal_tolerance[joint]));
  fail(blaming({own_error::kGoalTolerance, is_off ? where : "the robot still moves", ""},
               is_off ? static_cast<int>(joint) : -1),
       Event::Failed, now);
}

void TrajectoryRun::commandRefused(CommandKey /*key*/, const Failure& failure, Instant now) {
  fail(failure, Event::Failed, now);
}

std::optional<std::string> TrajectoryRun::stopsFor() const {
  return state_ == State::OffPath ? std::optional("it is off its path") : std::nullopt;
}

void TrajectoryRun::cancel(const std::string& why, Instant now) {
  if (state_ == State::Following) stopped_why_ = why + "; no motion was running";
  fire(Event::Cancel, now);
  if (!sent_) fire(Event::NothingLeft, now);
}

void TrajectoryRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  if (sent_ || state_ != State::Following) return;
  failure_ = Failure{motion_error::kLinkDropped, reason, ""};
  if (patience) reason_until_ = now + *patience;
  fire(patience ? Event::Unexplained : Event::Failed, now);
}

void TrajectoryRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (outcome()) return;
  joints_ = robot.joints();
  moving_ = robot.moving();
  if (sent_) {
    follow(robot, now);
  } else {
    lookWhileItWaits(robot, now);
  }
}

void TrajectoryRun::follow(const robot::RobotWatch& robot, Instant now) {
  if (!follower_ || ended_) return;
  if (robot.held()) {
    follower_->hold(now);
  } else {
    follower_->letGo(now);
  }
  tell(now);
  if (state_ != State::Following || !joints_) return;
  const auto offence = follower_->offence(*joints_, now);
  if (!offence) return;
  const double allowed = plan_->path_tolerance[offence->joint];
  fail(blaming(
           {own_error::kPathTolerance,
            fmt::format("J{} is {:.3f} deg off the trajectory, {:.3f} s after its start; allowed: {:.3f} deg",
                        offence->joint + 1, radToDeg(offence->gap), toSeconds(follower_->time(now)),
                        radToDeg(allowed)),
            ""},
           offence->joint),
       Event::LeftPath, now);
}

/// For its time to begin, or to be sent.
void TrajectoryRun::lookWhileItWaits(const robot::RobotWatch& robot, Instant now) {
  if (robot.emergencyStop()) {
    fail(emergencyStop(), Event::Failed, now);
  } else if (robot.inError()) {
    fail(robotError(robot), Event::Failed, now);
  } else if (state_ == State::Explaining) {
    tellStoppedProject(robot, failure_);
    if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
  }
}

void TrajectoryRun::tell(Instant now) {
  if (told_at_ && now - *told_at_ < kTellEvery) return;
  told_at_ = now;
  Progress progress = progress_;
  if (follower_) {
    TrajectoryPlace place;
    place.time = follower_->time(now);
    const motion::JointState desired = plan_->motion->at(place.time);
    place.desired = toArray(desired.position);
    place.desired_velocities = toArray(desired.velocity);
    if (joints_) place.actual = toArray(*joints_);
    progress.fraction = toSeconds(place.time) / toSeconds(plan_->motion->duration());
    progress.remaining = follower_->remaining(now);
    progress.detail = Detail(place);
  }
  report(std::move(progress));
}

// --- Ends.

/// The first one is the reason; what follows is of it.
void TrajectoryRun::fail(Failure failure, Event event, Instant now) {
  if (state_ == State::Ended) return;
  if (state_ != State::OffPath) failure_ = std::move(failure);
  fire(event, now);
}

void TrajectoryRun::fire(Event event, Instant now) {
  const auto row = findTransition<TrajectoryTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case TrajectoryAction::None:
      return;
    case TrajectoryAction::AwaitReason:
      reason_.begin(now);
      return;
    case TrajectoryAction::EndDone:
      complete(Outcome());
      return;
    case TrajectoryAction::EndStopped:
      complete(commandAborted(stopped_why_));
      return;
    case TrajectoryAction::EndFailed:
      complete(toOutcome(block(), Ending::Aborted, failure_));
      return;
  }
}

void TrajectoryRun::complete(Outcome outcome) {
  reason_until_.reset();
  outcome.command_id_ack = found_.command_id_ack;
  outcome.planned = found_.planned;
  outcome.actual = found_.actual;
  outcome.final_joints_deg = found_.final_joints_deg;
  outcome.final_pose_mm_deg = found_.final_pose_mm_deg;
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
