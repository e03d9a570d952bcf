#include "jog/jog_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jog/jog_ends.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

/// Twenty times a second.
constexpr Duration kTellEvery = std::chrono::milliseconds(50);
/// Project speeds are whole percents.
constexpr double kSameOverride = 0.005;
/// Moves of 0.2 s; or a velocity, and what changes it.
constexpr std::size_t kMostCommands = 6;

bool refusesVelocity(const Outcome& outcome) {
  const auto& lines = outcome.refused_lines;
  return std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.find("ContinueV") != std::string::npos; });
}

/// For the last bit of way in front of a limit a velocity would be too much.
std::unique_ptr<JogDrive> driveOf(const std::shared_ptr<const JogPlan>& plan) {
  const bool by_moves = plan->step || !plan->by_velocity || !hasRoomForVelocity(*plan, 0);
  return by_moves ? movesDrive(plan) : velocityDrive(plan);
}

}  // namespace

JogRun::JogRun(GoalId id, std::shared_ptr<const JogPlan> plan, Instant now)
    : Run(kBlock<JogGoal>, id), plan_(std::move(plan)), drive_(driveOf(plan_)), kept_(now) {
  look(now);
}

// --- What is sent.

std::size_t JogRun::window() const {
  return kMostCommands;
}

JogWish JogRun::wish() const {
  if (state_ == State::Driving) return JogWish::Drive;
  return state_ == State::Slowing ? JogWish::Rest : JogWish::Leave;
}

/// Another wish is another command, also while the one before is planned.
std::optional<Command> JogRun::next() const {
  const bool is_over = state_ != State::Driving && state_ != State::Slowing && state_ != State::Ending;
  if (is_over) return std::nullopt;
  const auto order = drive_->next(wish());
  if (!order) return std::nullopt;
  Command command;
  command.key = 4 * started_ + static_cast<CommandKey>(wish());
  command.block = block();
  command.traits.awaits_motion = order->awaits_end;
  command.order = [order = order->order](const arm::Pose& /*base*/) { return order; };
  return command;
}

void JogRun::commandStarted(CommandKey /*key*/) {
  drive_->started(wish());
  rest_taken_ = false;
  ++started_;
  ++open_;
}

void JogRun::look(Instant now) {
  if (state_ == State::Driving && drive_->isAtEnd(now)) {
    endAtTheObstacle();
    fire(Event::AtEnd, now);
  }
  if (state_ == State::Driving && !plan_->step && now >= kept_ + drive_->patience()) fire(Event::Late, now);
  drive_->look(now, kept_);
}

void JogRun::keepAlive(Instant now) {
  if (outcome()) return;
  kept_ = now;
  fire(Event::KeepAlive, now);
  look(now);
}

void JogRun::advance(Instant now) {
  look(now);
  if (rests_until_ && now >= *rests_until_ && open_ > 0) halt("the arm was not at standstill in time", now);
  if (reason_until_ && now >= *reason_until_) fire(Event::Failed, now);
  if (!outcome()) endWhenNothingIsLeft(now);
}

std::optional<Instant> JogRun::nextDeadline() const {
  std::optional<Instant> next = earlier(reason_until_, rests_until_);
  if (state_ != State::Driving) return next;
  if (!plan_->step) next = earlier(next, kept_ + drive_->patience());
  return earlier(next, drive_->nextDeadline(JogWish::Drive));
}

// --- What becomes of it.

void JogRun::commandProgressed(CommandKey /*key*/, const Progress& progress, Instant now) {
  if (progress.phase == Phase::Sent) {
    drive_->sent(now);
    look(now);
  }
  progress_ = progress;
  tell(now);
}

void JogRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant now) {
  if (open_ > 0) --open_;
  found_ = outcome;
  if (outcome.ending == Ending::CommandAborted) {
    if (!outcome.error_description.empty()) stopped_why_ = outcome.error_description;
    fire(Event::Cancel, now);
  } else if (outcome.ending == Ending::Done) {
    rest_taken_ = state_ == State::Slowing;
    if (open_ == 0 && drive_->means() == JogMeans::Velocity) endOfMode(now);
  } else if (!fallsBack(outcome)) {
    fail(failureOf(block(), outcome), now);
  }
  look(now);
  endWhenNothingIsLeft(now);
}

void JogRun::endOfMode(Instant now) {
  if (state_ != State::Driving) return;
  endBy(JogEnd::Released, -1, "the controller has ended its velocity mode");
  fire(Event::AtEnd, now);
}

/// Nothing was done yet. What came meanwhile holds.
bool JogRun::fallsBack(const Outcome& outcome) {
  if (drive_->means() != JogMeans::Velocity || started_ != 1 || !refusesVelocity(outcome)) return false;
  velocity_refused_ = true;
  drive_ = movesDrive(plan_);
  rests_until_.reset();
  return true;
}

void JogRun::commandRefused(CommandKey /*key*/, const Failure& failure, Instant now) {
  const JogEnd end = jogEndOf(failure.error_id);
  if (state_ == State::Driving && started_ > 0 && end != JogEnd::None) {
    endBy(end, -1, fmt::format("{}; the arm stops before that: {}", failure.found, wayOutOf(end)));
    fire(Event::AtEnd, now);
  } else {
    fail(failure, now);
  }
  endWhenNothingIsLeft(now);
}

void JogRun::endAtTheObstacle() {
  if (plan_->step) {
    endBy(JogEnd::IncrementDone, -1, "the increment is complete");
  } else if (!plan_->obstacle) {
    endBy(JogEnd::Longest, -1, "the jog has reached its planned maximum of ten minutes: send it again");
  } else {
    const JogEnd end = jogEndOf(*plan_->obstacle);
    endBy(end, plan_->obstacle->joint,
          fmt::format("{}; the arm stops before that: {}", plan_->obstacleText(), wayOutOf(end)));
  }
}

void JogRun::endBy(JogEnd end, int joint, std::string why) {
  if (report_.ended_by != JogEnd::None) return;
  report_.ended_by = end;
  report_.joint = joint;
  report_.why = std::move(why);
}

/// That was at the controller, and was stopped on its way.
void JogRun::forgetIncrement() {
  if (report_.ended_by != JogEnd::IncrementDone) return;
  report_.ended_by = JogEnd::None;
  report_.why.clear();
}

std::optional<std::string> JogRun::stopsFor() const {
  const bool stops = open_ > 0 && ((state_ == State::Stopping && halted_) || state_ == State::Failing);
  if (!stops) return std::nullopt;
  return state_ == State::Failing ? "a command of the jog failed" : stopped_why_;
}

void JogRun::cancel(const std::string& why, Instant now) {
  if (open_ == 0 && state_ == State::Driving) stopped_why_ = why + "; no motion was running";
  fire(Event::Cancel, now);
  endWhenNothingIsLeft(now);
}

void JogRun::halt(const std::string& why, Instant now) {
  if (state_ == State::Stopping || state_ == State::Failing || outcome()) return;
  stopped_why_ = why;
  halted_ = true;
  fire(Event::Cancel, now);
  endWhenNothingIsLeft(now);
}

void JogRun::finish(FinishAfter /*after*/, Instant now) {
  if (plan_->step) return;
  endBy(JogEnd::Released, -1, "finished");
  fire(Event::AtEnd, now);
  endWhenNothingIsLeft(now);
}

void JogRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  velocity_refused_ = false;  // the next controller is asked anew
  if (open_ > 0 || state_ != State::Driving) return;
  failure_ = Failure{motion_error::kLinkDropped, reason, ""};
  if (patience) reason_until_ = now + *patience;
  fire(patience ? Event::Unexplained : Event::Failed, now);
  endWhenNothingIsLeft(now);
}

// --- The robot.

void JogRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (outcome()) return;
  moving_ = robot.moving();
  if (const auto joints = robot.joints(); joints && joints->allFinite()) {
    driven_ = plan_->driveAt(*joints, driven_);
    drive_->see(driven_, now);
  }
  if (open_ > 0) {
    watch(robot, now);
  } else {
    lookWhileItWaits(robot, now);
  }
  if (outcome()) return;
  look(now);
  endWhenNothingIsLeft(now);
  if (!outcome()) tell(now);
}

/// What is held goes on by itself when it is let go: nobody may hold the jog then.
void JogRun::watch(const robot::RobotWatch& robot, Instant now) {
  if (plan_->step) return;
  if (robot.held()) {
    halt("the robot is paused or stopped by a safeguard: a jog does not resume automatically", now);
  } else if (!robot.status()) {
    halt("the status stream no longer shows where the robot is", now);
  } else if (std::abs(robot.speedOverride() - plan_->setting.speed_override) > kSameOverride) {
    halt("the project speed was changed: jog again", now);
  } else if (state_ == State::Slowing && rest_taken_ && moving_ == false &&
             drive_->means() == JogMeans::Velocity) {
    fire(Event::Standing, now);
  }
}

void JogRun::lookWhileItWaits(const robot::RobotWatch& robot, Instant now) {
  if (robot.emergencyStop()) {
    fail(emergencyStop(), now);
  } else if (robot.inError()) {
    fail(robotError(robot), now);
  } else if (robot.held() && !plan_->step) {
    halt("the robot is paused or stopped by a safeguard: resume it first", now);
  } else if (state_ == State::Explaining) {
    tellStoppedProject(robot, failure_);
    if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
  }
}

/// An increment is so only when it is stopped.
bool JogRun::isComingToRest() const {
  return !plan_->step && (state_ == State::Slowing || state_ == State::Ending);
}

void JogRun::tell(Instant now) {
  if (told_at_ && now - *told_at_ < kTellEvery) return;
  told_at_ = now;
  JogPlace place;
  place.means = drive_->means();
  place.way_mm = mToMm(plan_->wayOf(driven_));
  place.way_deg = radToDeg(plan_->turnOf(driven_));
  const double room = std::max(0.0, plan_->step.value_or(plan_->reach) - driven_);
  if (plan_->step || plan_->obstacle) {
    place.room_mm = mToMm(plan_->wayOf(room));
    place.room_deg = radToDeg(plan_->turnOf(room));
  }
  if (!plan_->step) place.keep_alive_age = now - kept_;
  Progress progress = progress_;
  if (isComingToRest()) {
    progress.phase = Phase::Stopping;
    progress.text = state_ == State::Slowing ? "no keep-alive: stopping" : "stopping: " + report_.why;
  } else if (velocity_refused_) {
    progress.text += "; by short moves, because the controller accepts no velocities";
  } else if (drive_->means() == JogMeans::Velocity && plan_->of_joints) {
    progress.text += "; by velocities: if this node or its link fails, the joints are not stopped";
  }
  progress.planned.reset();
  progress.remaining.reset();
  progress.fraction = plan_->step ? std::clamp(driven_, 0.0, 0.99) : 0.0;
  progress.detail = Detail(place);
  report(std::move(progress));
}

// --- Ends.

/// Nobody can tell the controller any more.
const char* JogRun::withoutLink() const {
  if (plan_->step) return "; the controller completes the increment";
  if (drive_->means() == JogMeans::Moves) {
    return "; the part of the jog at the controller ends within 0.2 s";
  }
  return plan_->of_joints ? "; if only the link failed, the controller keeps its velocity: the robot moves "
                            "until it is stopped there"
                          : "; without a velocity the controller stops the arm within 0.5 s";
}

/// The first one is the reason; what follows is of it.
void JogRun::fail(Failure failure, Instant now) {
  if (state_ == State::Ended) return;
  const bool is_first = state_ != State::Failing;
  if (is_first) failure_ = std::move(failure);
  if (is_first && started_ > 0 && failure_.error_id == motion_error::kLinkDropped) {
    failure_.found += withoutLink();
  }
  fire(Event::Failed, now);
  endWhenNothingIsLeft(now);
}

void JogRun::endWhenNothingIsLeft(Instant now) {
  if (open_ == 0) fire(Event::NothingLeft, now);
}

void JogRun::fire(Event event, Instant now) {
  const auto row = findTransition<JogTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  if (state_ == State::Driving || state_ == State::Stopping || state_ == State::Failing) rests_until_.reset();
  switch (row->action) {
    case JogAction::None:
      return;
    case JogAction::AwaitRest:
      told_at_.reset();
      if (const auto time = drive_->timeToRest()) rests_until_ = now + *time;
      return;
    case JogAction::AwaitReason:
      reason_.begin(now);
      return;
    case JogAction::EndDone:
      endBy(JogEnd::Released, -1, "no more keep-alives were received");
      complete(Outcome());
      return;
    case JogAction::EndStopped:
      forgetIncrement();
      complete(commandAborted(stopped_why_));
      return;
    case JogAction::EndFailed:
      forgetIncrement();
      complete(toOutcome(block(), Ending::Aborted, failure_));
      return;
  }
}

void JogRun::complete(Outcome outcome) {
  rests_until_.reset();
  reason_until_.reset();
  outcome.final_joints_deg = found_.final_joints_deg;
  outcome.final_pose_mm_deg = found_.final_pose_mm_deg;
  report_.means = started_ > 0 ? drive_->means() : JogMeans::None;
  report_.way_mm = mToMm(plan_->wayOf(driven_));
  report_.way_deg = radToDeg(plan_->turnOf(driven_));
  outcome.detail = Detail(report_);
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
