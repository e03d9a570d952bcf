#include "queue/motion_queue.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::simulator {
namespace {

/// What comes to where a line or an arc ends, but on any way.
std::optional<motion::Command> toTheSameEnd(const motion::Command& command) {
  using Wanted = std::optional<motion::Command>;
  return std::visit(
      Overloaded{[](const motion::Line& line) -> Wanted {
                   return motion::Ptp{motion::PoseTarget{line.target, {}}, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::Circle& circle) -> Wanted {
                   return motion::Ptp{motion::PoseTarget{circle.end, {}}, 1.0, circle.time_to_top_speed};
                 },
                 [](const motion::MoveLine& line) -> Wanted {
                   return motion::MovePtp{line.offset, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::PLine& line) -> Wanted {
                   const auto* pose = std::get_if<arm::Pose>(&line.target);
                   if (pose == nullptr) return std::nullopt;
                   return motion::Ptp{motion::PoseTarget{*pose, {}}, 1.0, line.time_to_top_speed};
                 },
                 [](const motion::MovePLine& line) -> Wanted {
                   return motion::MovePtp{line.offset, 1.0, line.time_to_top_speed};
                 },
                 [](const auto&) -> Wanted { return std::nullopt; }},
      command);
}

bool isUnreachable(const Result<motion::TrajectoryPtr, motion::Refusal>& planned) {
  return !planned && planned.error().reason == motion::Refusal::Reason::Unreachable;
}

Result<motion::TrajectoryPtr, RobotError> plan(const arm::ArmModel& arm, const arm::JointVector& start,
                                               const MotionRequest& request, const motion::Setting& setting) {
  const auto command = planning::toMotion(request);
  if (!command) return refuse(robotErrorFor(command.error(), false));
  auto planned = motion::plan(arm, start, *command, setting);
  if (planned) return *planned;
  const auto other = isUnreachable(planned) ? toTheSameEnd(*command) : std::nullopt;
  const bool reaches_end = other && !isUnreachable(motion::plan(arm, start, *other, setting));
  return refuse(robotErrorFor(planned.error(), reaches_end));
}

bool moves(const QueueItem& item) {
  return std::holds_alternative<MotionRequest>(item) || std::holds_alternative<VelocityMode>(item);
}

bool movesOrChangesTcp(const QueueItem& item) {
  return moves(item) || std::holds_alternative<TcpChange>(item);
}

bool isTag(const QueueItem& item) {
  return std::holds_alternative<QueuedTag>(item);
}

}  // namespace

MotionQueue::MotionQueue(const arm::ArmModel& arm, const arm::JointVector& posture, Options options,
                         FaultSwitch& stale_tag)
    : arm_(arm), options_(options), stale_tag_(stale_tag), posture_(posture), clock_(options.stop_time) {
  setting_.speed_override = options.speed_override;
  resetSetting();
}

void MotionQueue::resetSetting() {
  setting_.base = setting_.tcp = arm::Pose::Identity();
  base_name_ = script::kRobotBase;
  tcp_name_ = script::kNoTool;
  tcp_mass_ = load_ = 0.0;
  tcp_inertia_ = {};
  paused_ = pvt_paused_ = false;
  clearError();
  stale_tags_.clear();
}

void MotionQueue::setSpeedOverride(double override) {
  setting_.speed_override = override;
  next_.reset();  // it is planned anew
  if (active_) active_->looked_ahead = false;
}

void MotionQueue::push(QueueItem item) {
  if (pvt_) {
    pvt_->between.emplace_back(PvtMark{pvt_->time});
    pvt_->between.push_back(std::move(item));
    return;
  }
  if (moves(item) && !error_stands_) error_.reset();
  items_.push_back(std::move(item));
}

bool MotionQueue::run(Instant now) {
  bool ran = false;
  for (;; ran = true) {
    if (active_) {
      lookAhead(now);
      if (next_ && next_->takes_over_at && *next_->takes_over_at <= now) {
        takeOver(now);
      } else if (const auto mark = markAt(); mark && *mark <= now) {
        passMark(now);
      } else if (end_at_ && *end_at_ <= now) {
        endActive();
      } else {
        return ran;
      }
      continue;
    }
    if (velocity_) {
      if (velocity_->ends_at > now) return ran;
      velocity_.reset();
      continue;
    }
    if (items_.empty()) return ran;
    if (held() && moves(items_.front())) return ran;
    const QueueItem item = std::move(items_.front());
    items_.pop_front();
    std::visit([&](const auto& what) { apply(what, now); }, item);
  }
}

void MotionQueue::endActive() {
  posture_ = stopping_ ? at(*end_at_).position : active_->path->end().position;
  auto obstacle = std::move(active_->obstacle);
  active_.reset();
  end_at_.reset();
  pvt_paused_ = false;
  if (std::exchange(stopping_, false)) return;
  settleStaleTags();
  if (obstacle) fail(std::move(*obstacle));
}

void MotionQueue::settleStaleTags() {
  for (const QueuedTag& tag : std::exchange(stale_tags_, {})) settle(tag, true);
}

// What comes behind a motion that blends is planned as soon as it is known: it takes over before the end.
void MotionQueue::lookAhead(Instant now) {
  if (active_->looked_ahead || !active_->blend || stopping_) return;
  const auto behind = std::find_if(items_.begin(), items_.end(), movesOrChangesTcp);
  if (behind == items_.end()) return;
  active_->looked_ahead = true;
  const auto* request = std::get_if<MotionRequest>(&*behind);
  if (request == nullptr) return;  // at a change of the TCP the arm stops, and for velocities

  motion::Setting setting = setting_;
  double load = load_;
  for (auto item = items_.begin(); item != behind; ++item) {
    if (const auto* change = std::get_if<BaseChange>(&*item)) setting.base = change->pose;
    if (const auto* change = std::get_if<LoadChange>(&*item)) load = change->mass;
  }
  if (overloadBy(load)) return;  // it fails when its turn comes
  const auto planned = plan(arm_, active_->planned->end().position, *request, setting);
  if (!planned) return;  // likewise
  auto passage = motion::passInto(arm_, active_->planned, *planned, setting.tcp, *active_->blend,
                                  pathEnd() - clock_.pathTime(now));
  if (passage.overlap <= Duration::zero()) return;
  next_ = Next{std::move(passage), std::nullopt};
  schedule(now);
}

void MotionQueue::takeOver(Instant now) {
  const Next next = *std::exchange(next_, std::nullopt);
  settleStaleTags();
  for (;;) {
    const QueueItem item = std::move(items_.front());
    items_.pop_front();
    if (const auto* request = std::get_if<MotionRequest>(&item)) {
      return begin(*request, next.passage, now);
    }
    std::visit([&](const auto& what) { apply(what, now); }, item);
  }
}

void MotionQueue::begin(const MotionRequest& request, motion::Passage passage, Instant now) {
  const Duration start = active_ ? pathEnd() - passage.overlap : Duration::zero();
  const Duration duration = passage.planned->duration();
  active_ = Active{std::move(passage.path),
                   std::move(passage.planned),
                   planning::blendOf(request),
                   start,
                   false,
                   setting_.speed_override,
                   std::nullopt,
                   std::holds_alternative<planning::PvtBlock>(request)};
  schedule(now);
  events_.emplace_back(MotionStarted{duration});
}

void MotionQueue::schedule(Instant now) {
  end_at_ = clock_.reaches(pathEnd());
  if (!next_) return;
  const bool stands = held() && clock_.rate(now) <= 0.0;
  next_->takes_over_at = stands ? std::nullopt : clock_.reaches(pathEnd() - next_->passage.overlap);
}

void MotionQueue::apply(const MotionRequest& request, Instant now) {
  if (error_stands_) return fail(*error_);
  if (auto too_heavy = overloadBy(load_)) return fail(std::move(*too_heavy));
  const auto planned = plan(arm_, posture_, request, setting_);
  if (!planned) return fail(planned.error());
  clock_.start(now);
  begin(request, {Duration::zero(), *planned, *planned}, now);
}

std::optional<RobotError> MotionQueue::overloadBy(double load) const {
  return options_.checks_payload ? overload(arm_, tcp_mass_, load) : std::nullopt;
}

void MotionQueue::apply(const BaseChange& change, Instant) {
  setting_.base = change.pose;
  base_name_ = change.name;
}

void MotionQueue::apply(const TcpChange& change, Instant) {
  setting_.tcp = change.pose;
  tcp_name_ = change.name;
  tcp_mass_ = change.mass.value_or(tcp_mass_);
  tcp_inertia_ = change.inertia.value_or(tcp_inertia_);
}

void MotionQueue::apply(const LoadChange& change, Instant) {
  load_ = change.mass;
}

void MotionQueue::apply(const QueuedTag& tag, Instant) {
  settle(tag, !error_);
}

void MotionQueue::apply(const script::WriteOutput& write, Instant) {
  events_.emplace_back(write);
}

void MotionQueue::apply(const script::WriteAnalogOutput& write, Instant) {
  events_.emplace_back(write);
}

void MotionQueue::fail(RobotError error) {
  error_ = std::move(error);
  velocity_.reset();
  dropPvt();
  for (const QueueItem& item : std::exchange(items_, {})) {
    if (const auto* tag = std::get_if<QueuedTag>(&item)) settle(*tag, false);
  }
  events_.emplace_back(MotionFailed{*error_});
}

void MotionQueue::dropQueue() {
  velocity_.reset();
  dropPvt();
  const bool keeps_tags = std::any_of(items_.begin(), items_.end(), isTag) && stale_tag_.take();
  next_.reset();
  for (const QueueItem& item : std::exchange(items_, {})) {
    const auto* tag = std::get_if<QueuedTag>(&item);
    if (tag == nullptr) continue;
    if (keeps_tags) {
      stale_tags_.push_back(*tag);
    } else {
      events_.emplace_back(TagDropped{*tag});
    }
  }
}

Instant MotionQueue::nextEvent() const {
  if (!active_) return velocity_ ? velocity_->ends_at : Instant::max();
  const auto takes_over_at = next_ ? next_->takes_over_at.value_or(Instant::max()) : Instant::max();
  return std::min({end_at_.value_or(Instant::max()), takes_over_at, markAt().value_or(Instant::max())});
}

std::vector<QueueEvent> MotionQueue::takeEvents() {
  return std::exchange(events_, {});
}

bool& MotionQueue::heldBy(Holder holder) {
  switch (holder) {
    case Holder::Safeguard:
      return safeguarded_;
    case Holder::Pvt:
      return pvt_paused_;
    case Holder::Project:
      break;
  }
  return paused_;
}

void MotionQueue::pause(Instant now, Holder holder) {
  const bool stood = held();
  heldBy(holder) = true;
  if (stood || !active_ || stopping_) return;
  clock_.slowDown(now);
  schedule(now);
}

void MotionQueue::resume(Instant now, Holder holder) {
  const bool stood = held();
  heldBy(holder) = false;
  if (!stood || held() || !active_ || stopping_) return;
  clock_.speedUp(now);
  schedule(now);
}

void MotionQueue::stop(Instant now) {
  dropQueue();
  brake(now);
}

void MotionQueue::raise(RobotError error, Instant now) {
  brake(now);
  error_stands_ = true;
  fail(std::move(error));
}

void MotionQueue::clearError() {
  error_stands_ = false;
  error_.reset();
}

void MotionQueue::brake(Instant now) {
  next_.reset();
  if (!active_ || stopping_) return;
  stopping_ = true;
  if (!held()) clock_.slowDown(now);
  // A motion that comes to its end while it slows down ends there.
  end_at_ = std::max(now, std::min(clock_.settled(), clock_.reaches(pathEnd()).value_or(Instant::max())));
}

void MotionQueue::halt(Instant now) {
  posture_ = at(now).position;
  active_.reset();
  end_at_.reset();
  stopping_ = pvt_paused_ = false;
  dropQueue();
}

motion::JointState MotionQueue::at(Instant now) const {
  if (!active_) return {posture_, arm::JointVector::Zero()};
  motion::JointState state = active_->path->at(clock_.pathTime(now) - active_->start);
  state.velocity *= clock_.rate(now);
  return state;
}

bool MotionQueue::inMotion(Instant now) const {
  return active_ && clock_.rate(now) > 0.0;
}

int MotionQueue::motionCount() const {
  const auto waiting = std::count_if(items_.begin(), items_.end(), [](const QueueItem& item) {
    return std::holds_alternative<MotionRequest>(item);
  });
  return static_cast<int>(waiting) + (active_ ? 1 : 0);
}

}  // namespace cobot_command::simulator
