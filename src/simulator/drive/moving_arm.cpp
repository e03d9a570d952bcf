#include "drive/moving_arm.h"

#include <algorithm>
#include <utility>

namespace cobot_command::simulator {

void MovingArm::begin(ArmMotion motion, Instant now) {
  next_.reset();
  set(std::move(motion), Duration::zero());
  on(ArmEvent::Begin, now);
}

void MovingArm::set(ArmMotion motion, Duration start) {
  const bool blends = motion.blend.has_value();
  active_ = Active{std::move(motion), start, blends};
}

void MovingArm::brake(Instant now) {
  next_.reset();
  on(ArmEvent::Stop, now);
}

void MovingArm::halt(Instant now) {
  on(ArmEvent::Halt, now);
}

void MovingArm::setSpeedOverride(double override, Instant now) {
  if (!isOnPath()) return;
  clock_.setPace(now, override / active_->motion.speed_override);
  if (state_ == ArmState::Braking) return scheduleStop(now);
  schedule(now);
}

MovingArm::Ended MovingArm::end() {
  Ended ended{state_ == ArmState::Braking, std::move(active_->motion.obstacle)};
  on(ArmEvent::End, *end_at_);
  return ended;
}

void MovingArm::on(ArmEvent event, Instant now) {
  const auto row = findTransition<ArmTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  perform(row->action, now);
}

void MovingArm::perform(ArmAction action, Instant now) {
  switch (action) {
    case ArmAction::Start:
      clock_.start(now);
      return schedule(now);
    case ArmAction::SlowDown:
      clock_.slowDown(now);
      return schedule(now);
    case ArmAction::SpeedUp:
      clock_.speedUp(now);
      return schedule(now);
    case ArmAction::Brake:
      clock_.slowDown(now);
      return scheduleStop(now);
    case ArmAction::BrakeOn:
      return scheduleStop(now);
    case ArmAction::Arrive:
      return stand(active_->motion.path->end().position);
    case ArmAction::StandHere:
      return stand(onPath(now).position);
  }
}

void MovingArm::stand(const arm::JointVector& posture) {
  posture_ = posture;
  active_.reset();
  next_.reset();
  end_at_.reset();
}

void MovingArm::schedule(Instant now) {
  end_at_ = clock_.reaches(pathEnd());
  if (!next_) return;
  const bool stands = state_ == ArmState::Held && clock_.rate(now) <= 0.0;
  next_->takes_over_at = stands ? std::nullopt : clock_.reaches(pathEnd() - next_->overlap);
}

// A motion that comes to its end while it slows down ends there.
void MovingArm::scheduleStop(Instant now) {
  end_at_ = std::max(now, std::min(clock_.settled(), clock_.reaches(pathEnd()).value_or(Instant::max())));
}

motion::JointState MovingArm::at(Instant now) const {
  return isOnPath() ? onPath(now) : motion::JointState{posture_, arm::JointVector::Zero()};
}

motion::JointState MovingArm::onPath(Instant now) const {
  motion::JointState state = active_->motion.path->at(clock_.pathTime(now) - active_->start);
  state.velocity *= clock_.rate(now);
  return state;
}

std::optional<Instant> MovingArm::passes(double time) const {
  const ArmMotion& motion = active_->motion;
  const Duration place = active_->start + motion.lag + fromSeconds(time / motion.speed_override);
  return clock_.reaches(std::min(place, pathEnd()));
}

bool MovingArm::seeksNext() const {
  return state_ != ArmState::Braking && active_->seeks_next;
}

void MovingArm::seekAnew() {
  next_.reset();
  if (active_) active_->seeks_next = active_->motion.blend.has_value();
}

void MovingArm::prepareNext(ArmMotion next, Duration overlap, Instant now) {
  next_ = Next{std::move(next), overlap, std::nullopt};
  schedule(now);
}

std::optional<Instant> MovingArm::takesOverAt() const {
  return next_ ? next_->takes_over_at : std::nullopt;
}

void MovingArm::takeOver(Instant now) {
  Next next = *std::exchange(next_, std::nullopt);
  set(std::move(next.motion), pathEnd() - next.overlap);
  schedule(now);
}

}  // namespace cobot_command::simulator
