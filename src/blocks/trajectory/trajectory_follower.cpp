#include "trajectory/trajectory_follower.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cobot_command::blocks {
namespace {

/// The stream tells of an arm that may be so far behind the clock, or a little in front of it.
constexpr Duration kBehind = std::chrono::milliseconds(500);
constexpr Duration kInFront = std::chrono::milliseconds(50);
/// So much further on from one frame to the next, in front of the clock.
constexpr Duration kAhead = std::chrono::milliseconds(500);
/// On its way out of a hold it is behind by as long as it took to stop and to speed up.
constexpr Duration kBehindHold = std::chrono::milliseconds(1000);
constexpr Duration kStep = std::chrono::milliseconds(10);
constexpr Duration kFinestStep = std::chrono::microseconds(50);

}  // namespace

TrajectoryFollower::TrajectoryFollower(std::shared_ptr<const TrajectoryPlan> plan, double rate, Instant now)
    : plan_(std::move(plan)), clock_(rate, now) {}

void TrajectoryFollower::hold(Instant now) {
  clock_.hold(now);
}

void TrajectoryFollower::letGo(Instant now) {
  if (clock_.letGo(now)) judged_from_ = now + kBehindHold;
}

std::optional<TrajectoryFollower::Offence> TrajectoryFollower::offence(const arm::JointVector& joints,
                                                                       Instant now) {
  if (!joints.allFinite() || clock_.isHeld() || (judged_from_ && now < *judged_from_)) return std::nullopt;
  const Duration clock = time(now);
  // A hold shows a little later than it began, so the clock may be ahead for good behind one.
  const Duration behind = judged_from_ ? kBehindHold : kBehind;
  Duration place = nearest(joints, clock - behind, clock + kInFront);
  if (shareAt(place, joints) > 1.0) {
    // Or else it goes on in front of the clock, as a simulation does that is faster than the time.
    const Duration ahead = std::max(seen_, clock);
    const Duration further = nearest(joints, ahead, ahead + kAhead);
    if (shareAt(further, joints) < shareAt(place, joints)) place = further;
  }
  seen_ = place;
  const arm::JointVector gap = gapAt(place, joints);
  Eigen::Index joint = 0;
  if (gap.cwiseQuotient(plan_->path_tolerance).maxCoeff(&joint) <= 1.0) return std::nullopt;
  return Offence{static_cast<int>(joint), gap[joint]};
}

Duration TrajectoryFollower::nearest(const arm::JointVector& joints, Duration from, Duration until) const {
  Duration best = from;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](Duration time) {
    const double share = shareAt(time, joints);
    if (share >= least) return;
    least = share;
    best = time;
  };
  for (Duration time = from; time <= until; time += kStep) look(time);
  for (Duration step = kStep / 2; step > kFinestStep && least > 1.0; step /= 2) {
    const Duration around = best;
    look(around - step);
    look(around + step);
  }
  return best;
}

arm::JointVector TrajectoryFollower::gapAt(Duration time, const arm::JointVector& joints) const {
  return (plan_->motion->at(time).position - joints).cwiseAbs();
}

double TrajectoryFollower::shareAt(Duration time, const arm::JointVector& joints) const {
  return gapAt(time, joints).cwiseQuotient(plan_->path_tolerance).maxCoeff();
}

Duration TrajectoryFollower::time(Instant now) const {
  return std::clamp(clock_.time(now), Duration::zero(), plan_->motion->duration());
}

Duration TrajectoryFollower::remaining(Instant now) const {
  return clock_.byController(plan_->motion->duration() - time(now));
}

}  // namespace cobot_command::blocks
