#include "queue/motion_queue.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::simulator {

namespace {

bool isOfTcp(const Velocity& velocity) {
  return std::holds_alternative<motion::TcpVelocity>(velocity);
}

bool isRest(const Velocity& velocity) {
  return std::visit(Overloaded{[](const arm::JointVector& joints) { return joints.isZero(0.0); },
                               [](const motion::TcpVelocity& tcp) {
                                 return tcp.linear.isZero(0.0) && tcp.angular.isZero(0.0);
                               }},
                    velocity);
}

}  // namespace

MotionQueue::MotionQueue(const arm::ArmModel& arm, const arm::JointVector& posture, Options options,
                         FaultSwitches& faults)
    : planner_(arm, options, faults.pvt_linear),
      arm_(posture, options.stop_time),
      reports_(faults.stale_tag) {}

void MotionQueue::resetSetting(const arm::Pose& tcp, Instant now) {
  setting_ = ToolAndBase{};
  if (!tcp.isApprox(arm::Pose::Identity())) {
    setting_.tcp = tcp;
    setting_.tcp_name.clear();
  }
  resume(now, Holder::Project);
  resume(now, Holder::Pvt);
  errors_.clear();
  reports_.forgetKept();
}

void MotionQueue::setSpeedOverride(double override, Instant now) {
  planner_.setSpeedOverride(override);
  if (!planner_.liveSpeed()) return arm_.seekAnew();
  if (!velocities_.on()) arm_.setSpeedOverride(override, now);
}

void MotionQueue::push(QueueEntry entry) {
  if (moves(entry)) errors_.motionQueued();
  waiting_.push(std::move(entry));
}

// --- Time --------------------------------------------------------------------------------------------------

bool MotionQueue::run(Instant now) {
  bool ran = false;
  while (step(now)) ran = true;
  return ran;
}

bool MotionQueue::step(Instant now) {
  if (arm_.isOnPath()) return stepOnPath(now);
  if (velocities_.on()) {
    if (velocities_.endsAt() > now) return false;
    velocities_.drop();
    return true;
  }
  if (waiting_.empty() || (holds_.any() && moves(waiting_.front()))) return false;
  apply(waiting_.take(), now);
  return true;
}

bool MotionQueue::stepOnPath(Instant now) {
  const auto is_due = [now](const std::optional<Instant>& at) { return at && *at <= now; };
  lookAhead(now);
  if (is_due(arm_.takesOverAt())) {
    takeOver(now);
  } else if (is_due(markAt())) {
    waiting_.take();
    apply(waiting_.take(), now);
  } else if (is_due(arm_.endsAt())) {
    endMotion();
  } else {
    return false;
  }
  return true;
}

Instant MotionQueue::nextEvent() const {
  if (!arm_.isOnPath()) return velocities_.endsAt();
  const auto due = [](const std::optional<Instant>& at) { return at.value_or(Instant::max()); };
  return std::min({due(arm_.endsAt()), due(arm_.takesOverAt()), due(markAt())});
}

std::optional<Instant> MotionQueue::markAt() const {
  const PvtMark* mark = arm_.state() == ArmState::Braking ? nullptr : waiting_.mark();
  return mark == nullptr ? std::nullopt : arm_.passes(mark->time);
}

void MotionQueue::endMotion() {
  MovingArm::Ended ended = arm_.end();
  holds_.remove(Holder::Pvt);
  if (ended.was_stopped) return;
  reports_.settleKept();
  if (ended.obstacle) fail(std::move(*ended.obstacle));
}

// What comes behind a motion that blends is planned as soon as it is known: it takes over before the end.
void MotionQueue::lookAhead(Instant now) {
  if (!arm_.seeksNext()) return;
  const auto ahead = waiting_.lookAhead(setting_);
  if (!ahead) return;
  arm_.seekNoMore();
  if (ahead->motion == nullptr) return;
  auto blended = planner_.planBehind(arm_.motion(), arm_.left(now), *ahead->motion, ahead->setting);
  if (blended) arm_.prepareNext(std::move(blended->next), blended->overlap, now);
}

void MotionQueue::takeOver(Instant now) {
  reports_.settleKept();
  for (QueueEntry entry = waiting_.take(); !moves(entry); entry = waiting_.take()) apply(entry, now);
  arm_.takeOver(now);
  reports_.add(MotionStarted{arm_.motion().planned->duration()});
}

// --- Entries -----------------------------------------------------------------------------------------------

void MotionQueue::apply(const QueueEntry& entry, Instant now) {
  std::visit(Overloaded{[&](const MotionRequest& request) { start(request, now); },
                        [&](const VelocityMode& mode) {
                          if (errors_.stands()) return fail(*error());
                          velocities_.begin(mode, now);
                          if (mode.first) drive(*mode.first, now);
                        },
                        [&](const QueuedTag& tag) { reports_.settle({tag}, !error()); },
                        [](const PvtMark&) {},  // the PVT is over
                        [&](const script::WriteOutput& write) { reports_.add(write); },
                        [&](const script::WriteAnalogOutput& write) { reports_.add(write); },
                        [&](const auto& change) { setting_.apply(change); }},
             entry);
}

void MotionQueue::start(const MotionRequest& request, Instant now) {
  if (errors_.stands()) return fail(*error());
  auto planned = planner_.plan(arm_.at(now).position, request, setting_);
  if (!planned) return fail(std::move(planned.error()));
  const Duration duration = planned->planned->duration();
  arm_.begin(std::move(*planned), now);
  reports_.add(MotionStarted{duration});
}

void MotionQueue::fail(RobotError error) {
  errors_.motionFailed(error);
  velocities_.drop();
  reports_.settle(waiting_.giveUp(), false);
  reports_.add(MotionFailed{std::move(error)});
}

void MotionQueue::giveUp() {
  velocities_.drop();
  reports_.dropOrKeep(waiting_.giveUp());
}

// --- From outside ------------------------------------------------------------------------------------------

void MotionQueue::pause(Instant now, Holder holder) {
  if (holder == Holder::Pvt && !(arm_.isOnPath() && arm_.motion().is_pvt)) return;
  holds_.add(holder);
  arm_.hold(now);
}

void MotionQueue::resume(Instant now, Holder holder) {
  holds_.remove(holder);
  if (!holds_.any()) arm_.release(now);
}

void MotionQueue::stop(Instant now) {
  giveUp();
  arm_.brake(now);
}

void MotionQueue::raise(RobotError error, Instant now) {
  arm_.brake(now);
  errors_.robotFailed(error);
  fail(std::move(error));
}

void MotionQueue::halt(Instant now) {
  arm_.halt(now);
  holds_.remove(Holder::Pvt);
  giveUp();
}

// --- Velocities --------------------------------------------------------------------------------------------

std::optional<std::string> MotionQueue::setVelocity(const Velocity& velocity, Instant now) {
  const bool of_tcp = isOfTcp(velocity);
  if (velocities_.takes(of_tcp)) {
    if (holds_.any()) return "the robot is paused and accepts no velocity: resume it first";
    velocities_.renew(now);
    drive(velocity, now);
    return std::nullopt;
  }
  if (waiting_.giveVelocity(velocity, of_tcp)) return std::nullopt;
  return of_tcp ? "the arm accepts no velocity of the TCP: call ContinueVLine() first"
                : "the arm accepts no velocities of the joints: call ContinueVJog() first";
}

// Each velocity is a motion of its own, from the state that the arm has.
void MotionQueue::drive(const Velocity& velocity, Instant now) {
  if (isRest(velocity)) return arm_.brake(now);
  auto planned = planner_.planVelocity(arm_.at(now), velocity, velocities_.lasting(), setting_);
  if (planned) return arm_.begin(std::move(*planned), now);
  arm_.brake(now);
  fail(std::move(planned.error()));
}

void MotionQueue::suspendVelocity(Instant now) {
  if (velocities_.on()) arm_.brake(now);
}

void MotionQueue::endVelocity(Instant now) {
  suspendVelocity(now);
  velocities_.endAt(now);
  waiting_.removeVelocityModes();
}

void MotionQueue::leaveModes(Instant now) {
  endVelocity(now);
  reports_.drop(waiting_.giveUpPvt());
}

}  // namespace cobot_command::simulator
