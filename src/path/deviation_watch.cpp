#include "cobot_command/path/deviation_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::path {
namespace {

/// Nearer is not worth looking for [m].
constexpr double kNoDistance = 1e-9;

/// The vertex of the parabola through three values at -1, 0 and 1; the middle one is the least.
double leastBetween(double before, double middle, double behind) {
  const double bend = before - 2.0 * middle + behind;
  return bend > 0.0 ? std::clamp(0.5 * (before - behind) / bend, -0.5, 0.5) : 0.0;
}

}  // namespace

DeviationWatch::DeviationWatch(arm::ArmModel arm, PathPlan plan)
    : arm_(std::move(arm)), plan_(std::move(plan)) {}

void DeviationWatch::add(Duration time, const arm::JointVector& joints) {
  if (!joints.allFinite()) return;
  for (std::size_t i = 0; i < kDelays; ++i) {
    squares_[i] += (joints - plan_.at(time - delay(i)).position).squaredNorm();
  }
  joint_ = std::max(joint_, (joints - plan_.at(time).position).cwiseAbs().maxCoeff());
  last_ = nearest(time, joints);
  path_ = std::max(path_, last_);
}

Eigen::Vector3d DeviationWatch::placeOf(const arm::JointVector& joints, std::size_t point) const {
  return (arm::forwardKinematics(arm_, joints) * plan_.points()[point].moved_frame).translation();
}

/// From the place on the curve where the plan has the arm at `time`, by the frame that is moved there.
double DeviationWatch::distanceAt(Duration time, const arm::JointVector& joints) const {
  const std::size_t point = plan_.placeAt(time).point;
  return (placeOf(joints, point) - placeOf(plan_.at(time).position, point)).norm();
}

/// The arm is late rather than early, and not by more than the longest delay. Around a corner the curve comes
/// near more than once, so each place that is nearer than those beside it is looked at.
double DeviationWatch::nearest(Duration time, const arm::JointVector& joints) const {
  if (plan_.points().empty()) return 0.0;
  std::array<double, kDelays> distances{};
  for (std::size_t i = 0; i < kDelays; ++i) distances[i] = distanceAt(time - delay(i), joints);
  double least = distances.front();
  for (std::size_t i = 0; i < kDelays; ++i) {
    const bool is_least = (i == 0 || distances[i] <= distances[i - 1]) &&
                          (i + 1 == kDelays || distances[i] <= distances[i + 1]);
    if (is_least) least = std::min(least, nearestAround(time - delay(i), distances[i], joints));
  }
  return least;
}

double DeviationWatch::nearestAround(Duration time, double least, const arm::JointVector& joints) const {
  for (Duration step = kDelay / 2; step > std::chrono::microseconds(10) && least > kNoDistance; step /= 2) {
    for (const Duration at : {time - step, time + step}) {
      const double found = distanceAt(at, joints);
      if (found < least) {
        least = found;
        time = at;
      }
    }
  }
  return least;
}

Deviation DeviationWatch::deviation() const {
  const auto least = std::min_element(squares_.begin(), squares_.end());
  const auto index = static_cast<std::size_t>(least - squares_.begin());
  double lag = toSeconds(delay(index));
  if (index > 0 && index + 1 < kDelays) {
    lag += leastBetween(*(least - 1), *least, *(least + 1)) * toSeconds(kDelay);
  }
  return {joint_, path_, std::max(0.0, lag)};
}

}  // namespace cobot_command::path
