#include "arbiter/interrupt_desk.h"

#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

/// A joint that differs by more is elsewhere: what the streams of real controllers round is far less.
constexpr double kElsewhere = degToRad(0.1);
constexpr const char* kInterrupted = "interrupted by the service interrupt";

InterruptAnswer refusal(int error_id, std::string message) {
  return {false, error_id, std::move(message)};
}

/// In the words of a block that is refused for the same reasons.
InterruptAnswer toAnswer(const blocks::Failure& failure) {
  const auto outcome =
      blocks::toOutcome(blocks::kBlock<blocks::ReturnToPrimaryGoal>, blocks::Ending::Rejected, failure);
  return refusal(failure.error_id, outcome.error_description + ". " + outcome.remedy);
}

}  // namespace

void InterruptDesk::interrupt(const InterruptReply& reply, Instant now) {
  if (const auto objection = objectionToInterrupting(); objection.error_id != 0) {
    reply(objection);
    return;
  }
  waiting_.push_back(reply);
  fire(Event::Asked, now);
}

InterruptAnswer InterruptDesk::objectionToInterrupting() const {
  if (state_ == State::Interrupted) {
    return refusal(blocks::own_error::kInterruption, "it is already interrupted: continue resumes it");
  }
  if (const auto objections = parts_.keeper.objectionsToCommands(); !objections.empty()) {
    return toAnswer(objections.front());
  }
  if (state_ == State::Stopping) return {};
  if (desks_.stops.busy()) return refusal(kContinueWhileStopping, "the robot is being stopped");
  const bool is_there = turns_.isAnythingThere() || !desks_.queue.empty() || desks_.window.mayMove() ||
                        parts_.forecast.loose().mayMove();
  if (!is_there) {
    return refusal(blocks::own_error::kInterruption, "no goal is running or queued");
  }
  if (!parts_.robot.joints()) {
    return refusal(blocks::own_error::kStartUnknown,
                   parts_.robot.whyNoJoints() + "; or use stop, which discards all goals");
  }
  if (const auto why = whyNotLater()) {
    return refusal(blocks::own_error::kInterruption,
                   fmt::format("the running goal could not be continued later: {}; use stop, which discards "
                               "all goals, or PAUSE of program_control, which leaves the robot where it is",
                               *why));
  }
  return {};
}

std::optional<std::string> InterruptDesk::whyNotLater() const {
  using GoesOn = blocks::Run::GoesOn;
  const GoesOn goes_on = turns_.run() != nullptr ? turns_.run()->goesOn() : GoesOn::ByCommands;
  if (goes_on == GoesOn::Never) return fmt::format("{} cannot", toString(turns_.run()->block()));
  if (goes_on == GoesOn::ByCommands) return turns_.sender().objectionToResuming();
  if (turns_.sender().hasSent() && parts_.forecast.loose().mayMove()) {
    return "a blended motion before the path is running";
  }
  const blocks::PathPace pace = desks_.paths.pace();
  const bool can_restart = desks_.window.empty() || pace.can_restart || pace.is_restarting;
  return can_restart ? std::nullopt : std::optional<std::string>("the path is ending, or is being stopped");
}

void InterruptDesk::goOn(const InterruptReply& reply, Instant now) {
  if (const auto objection = objectionToGoingOn(); objection.error_id != 0) {
    reply(objection);
    return;
  }
  fire(Event::Continued, now);
  reply({true, 0, goesOnText()});
}

InterruptAnswer InterruptDesk::objectionToGoingOn() const {
  if (state_ == State::Stopping) return refusal(kContinueWhileStopping, "the robot is being stopped");
  if (!desks_.aside.isThere()) {
    return refusal(blocks::own_error::kInterruption, "nothing is interrupted");
  }
  blocks::GoalTraits moving;
  moving.may_move = true;
  if (const auto objections = parts_.permit.objectionsTo(moving); !objections.empty()) {
    return toAnswer(objections.front());
  }
  if (!parts_.keeper.isRobotEnabled(parts_.robot)) {
    return refusal(kContinueNotEnabled,
                   "emergency stop, an error of the controller, or no link: see command_status");
  }
  const bool moves = desks_.stops.busy() || turns_.isAnythingThere() || !desks_.queue.empty() ||
                     parts_.forecast.loose().mayMove() || parts_.robot.moving().value_or(false);
  if (moves) {
    return refusal(kContinueWhileStopping, "the robot moves, or another goal is running: wait for it");
  }
  if (!parts_.robot.joints()) {
    return refusal(blocks::own_error::kStartUnknown, parts_.robot.whyNoJoints());
  }
  const PrimaryPosition& position = *desks_.aside.position();
  if (!isAt(position.joints) && !(position.segment_end && isAt(*position.segment_end))) {
    return refusal(kContinueNotThere,
                   fmt::format("{} from where it was interrupted; allowed: 0.1 deg: use return_to_primary",
                               awayText(position.joints)));
  }
  if (const auto difference = desks_.aside.objectionTo(setup())) {
    return refusal(difference->error_id,
                   difference->found + ": set it as it was, or use return_to_primary with allow_differences");
  }
  return {};
}

std::optional<blocks::Goal> InterruptDesk::withPlace(const blocks::Goal& goal) const {
  const auto* const way_back = std::get_if<blocks::ReturnToPrimaryGoal>(&goal);
  const auto joints = parts_.robot.joints();
  const arm::ArmModel* const arm = parts_.forecast.arm();
  if (way_back == nullptr || !desks_.aside.isThere() || !joints || arm == nullptr) return std::nullopt;
  const PrimaryPosition& position = *desks_.aside.position();
  const robot::ActiveFrames frames = parts_.forecast.frames();
  const arm::Pose tcp = frames.tcp.value_or(arm::Pose::Identity());
  const arm::Pose now = arm::forwardKinematics(*arm, *joints) * tcp;
  const auto target_at = [&](const arm::JointVector& at) {
    const arm::Pose there = arm::forwardKinematics(*arm, at) * tcp;
    return blocks::ReturnTarget{at, there, mToMm((there.translation() - now.translation()).norm())};
  };
  blocks::ReturnPlace place{target_at(position.joints), std::nullopt, differenceIn(position.setup, setup())};
  if (position.segment_end) place.segment_end = target_at(*position.segment_end);
  blocks::ReturnToPrimaryGoal filled = *way_back;
  filled.place = std::move(place);
  return blocks::Goal(std::move(filled));
}

void InterruptDesk::look(Instant now) {
  if (state_ == State::Interrupted && !desks_.aside.isThere()) fire(Event::NothingLeft, now);
  if (state_ != State::Stopping) return;
  if (!turns_.isStoppingForLater()) {
    fire(Event::NothingLeft, now);
  } else if (turns_.hasStoppedForLater()) {
    fire(Event::Stands, now);
  }
}

void InterruptDesk::fire(Event event, Instant now) {
  const auto row = findTransition<InterruptTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case InterruptAction::None:
      return;
    case InterruptAction::Stop:
      turns_.stopForLater(kInterrupted, now);
      return;
    case InterruptAction::SetAside:
      setAside(now);
      return;
    case InterruptAction::TellLost:
      answer(refusal(blocks::own_error::kInterruption,
                     "the running goal ended before it could be suspended: see its result"));
      return;
    case InterruptAction::PutBack:
      putBack(now);
      return;
  }
}

void InterruptDesk::setAside(Instant now) {
  Aside aside = turns_.takeAside(now);
  PrimaryPosition position{*parts_.robot.joints(), std::nullopt, setup()};
  if (!aside.left.empty()) position.segment_end = aside.left.front().segment_end;
  desks_.aside.put(std::move(aside), std::move(position), now);
  if (desks_.aside.isEmpty()) {  // it was done in that very moment
    desks_.aside.drop(kInterrupted, now);
    answer(refusal(blocks::own_error::kInterruption,
                   "the running goal was done before it could be interrupted"));
    return;
  }
  const std::size_t waiting = desks_.aside.waiting();
  const auto block = desks_.aside.block();
  answer({true, 0,
          fmt::format("interrupted{}; {} wait{}: continue resumes from here",
                      desks_.aside.underWay() != 0 ? fmt::format(": {}", toString(*block)) : "", waiting,
                      waiting == 1 ? "s" : "")});
}

void InterruptDesk::putBack(Instant now) {
  const bool behind_segment = !isAt(desks_.aside.position()->joints);
  Aside aside = desks_.aside.take(behind_segment, now);
  if (aside.run && !aside.run->leavesTheRobot()) {  // waits tell how they go on
    blocks::Progress progress;
    progress.phase =
        parts_.speed.isZero() || parts_.robot.held() ? blocks::Phase::Held : blocks::Phase::Active;
    progress.text = goesOnText();
    parts_.board.progress(aside.run->block(), aside.run->goal(), std::move(progress));
  }
  turns_.putBack(std::move(aside), now);
}

Setup InterruptDesk::setup() const {
  return {parts_.forecast.frames(), parts_.forecast.load()};
}

std::string InterruptDesk::goesOnText() const {
  if (parts_.speed.isZero()) return "continues when the speed override is above 0 %";
  if (parts_.robot.held()) return "continues when the pause or the safeguard is released";
  return "continues from where it was interrupted";
}

bool InterruptDesk::isAt(const arm::JointVector& place) const {
  return (*parts_.robot.joints() - place).cwiseAbs().maxCoeff() <= kElsewhere;
}

std::string InterruptDesk::awayText(const arm::JointVector& place) const {
  Eigen::Index joint = 0;
  const double away = (*parts_.robot.joints() - place).cwiseAbs().maxCoeff(&joint);
  return fmt::format("J{} is {:.2f} deg", joint + 1, radToDeg(away));
}

void InterruptDesk::answer(const InterruptAnswer& answer) {
  for (const InterruptReply& reply : std::exchange(waiting_, {})) reply(answer);
}

}  // namespace cobot_command::command
