// What the queue does between PVTEnter and PVTExit, and while the arm takes velocities.
#include <algorithm>
#include <utility>

#include "queue/motion_queue.h"

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

const planning::PvtBlock* pvtIn(const QueueItem& item) {
  const auto* request = std::get_if<MotionRequest>(&item);
  return request == nullptr ? nullptr : std::get_if<planning::PvtBlock>(request);
}

std::optional<Duration> shorter(const std::optional<Duration>& a, const std::optional<Duration>& b) {
  return a && b ? std::min(*a, *b) : (a ? a : b);
}

}  // namespace

// --- PVT ---------------------------------------------------------------------------------------------------

void MotionQueue::addPoint(const script::PvtPoint& point) {
  pvt_->block.points.push_back(point);
  pvt_->time += point.duration;
}

void MotionQueue::closePvt() {
  OpenPvt pvt = *std::exchange(pvt_, std::nullopt);
  push(MotionRequest(std::move(pvt.block)));
  std::move(pvt.between.begin(), pvt.between.end(), std::back_inserter(items_));
}

void MotionQueue::dropPvt() {
  if (!pvt_) return;
  OpenPvt pvt = *std::exchange(pvt_, std::nullopt);
  std::move(pvt.between.begin(), pvt.between.end(), std::back_inserter(items_));
}

std::optional<Instant> MotionQueue::markAt() const {
  if (!active_ || stopping_ || items_.empty()) return std::nullopt;
  const auto* mark = std::get_if<PvtMark>(&items_.front());
  if (mark == nullptr) return std::nullopt;
  return clock_.reaches(
      std::min(active_->start + fromSeconds(mark->time / active_->speed_override), pathEnd()));
}

void MotionQueue::passMark(Instant now) {
  items_.pop_front();
  const QueueItem item = std::move(items_.front());
  items_.pop_front();
  std::visit([&](const auto& what) { apply(what, now); }, item);
}

void MotionQueue::pausePvt(Instant now) {
  if (active_ && active_->is_pvt) pause(now, Holder::Pvt);
}

std::size_t MotionQueue::size() const {
  std::size_t all = items_.size();
  for (const QueueItem& item : items_) {
    if (const auto* pvt = pvtIn(item)) all += pvt->points.size();
  }
  return all + (pvt_ ? pvt_->block.points.size() + pvt_->between.size() : 0);
}

// --- Velocities --------------------------------------------------------------------------------------------

void MotionQueue::apply(const VelocityMode& mode, Instant now) {
  if (error_stands_) return fail(*error_);
  velocity_ = Velocities{mode, mode.time_to_end ? now + *mode.time_to_end : Instant::max()};
  if (mode.first) drive(*mode.first, now);
}

std::optional<std::string> MotionQueue::setVelocity(const Velocity& velocity, Instant now) {
  const bool of_tcp = isOfTcp(velocity);
  if (velocity_ && velocity_->mode.of_tcp == of_tcp) {
    if (held()) return "the robot is paused, and takes no velocity: let it go on first";
    if (const auto limit = velocity_->mode.time_to_end) velocity_->ends_at = now + *limit;
    drive(velocity, now);
    return std::nullopt;
  }
  for (QueueItem& item : items_) {
    auto* mode = std::get_if<VelocityMode>(&item);
    if (mode == nullptr || mode->of_tcp != of_tcp) continue;
    mode->first = velocity;
    return std::nullopt;
  }
  return of_tcp ? "the arm takes no velocity of the TCP: ContinueVLine() first"
                : "the arm takes no velocities of the joints: ContinueVJog() first";
}

// Each velocity is a motion of its own, from the state that the arm has.
void MotionQueue::drive(const Velocity& velocity, Instant now) {
  if (isRest(velocity)) return suspendVelocity(now);
  if (auto too_heavy = overloadBy(load_)) {
    brake(now);
    return fail(std::move(*too_heavy));
  }
  const VelocityMode& mode = velocity_->mode;
  auto planned = motion::planVelocity(
      arm_, at(now), {velocity, options_.stop_time, shorter(mode.time_to_rest, mode.time_to_end)}, setting_);
  if (!planned) {
    brake(now);
    return fail(robotErrorFor(planned.error(), false));
  }
  Active active{planned->trajectory, planned->trajectory, {}, {}, true, setting_.speed_override, {}, false};
  if (planned->ends_at) active.obstacle = robotErrorFor(*planned->ends_at, false);
  active_ = std::move(active);
  stopping_ = false;
  clock_.start(now);
  schedule(now);
}

void MotionQueue::suspendVelocity(Instant now) {
  if (velocity_) brake(now);
}

void MotionQueue::endVelocity(Instant now) {
  suspendVelocity(now);
  if (velocity_) velocity_->ends_at = now;
  const auto waits = [](const QueueItem& item) { return std::holds_alternative<VelocityMode>(item); };
  items_.erase(std::remove_if(items_.begin(), items_.end(), waits), items_.end());
}

void MotionQueue::leaveModes(Instant now) {
  endVelocity(now);
  if (!pvt_) return;
  for (const QueueItem& item : pvt_->between) {
    if (const auto* tag = std::get_if<QueuedTag>(&item)) events_.emplace_back(TagDropped{*tag});
  }
  pvt_.reset();
}

}  // namespace cobot_command::simulator
