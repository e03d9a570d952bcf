#include "cobot_command/cell/bodies/mechanism_bodies.h"

#include <algorithm>
#include <utility>

namespace cobot_command::cell {
namespace {

/// Of the farthest point. The distance from a line is convex, so of the core it is an end.
double farthestFromAxis(const Capsule& capsule, const Eigen::Vector3d& direction) {
  return std::max(direction.cross(capsule.from).norm(), direction.cross(capsule.to).norm()) + capsule.radius;
}

}  // namespace

MechanismBodies::MechanismBodies(const MotionAxis& axis, Capsules capsules)
    : axis_(axis), capsules_(std::move(capsules)) {
  // How far a point is from the axis stays the same while it turns; the chord is no longer than the arc.
  for (const Capsule& capsule : capsules_) {
    reach_.push_back(axis.turns ? farthestFromAxis(capsule, axis.direction) : 1.0);
  }
}

Result<MechanismBodies, BodyRefusal> MechanismBodies::of(const MotionAxis& axis,
                                                         const std::vector<Shape>& shapes, double body_cell) {
  auto capsules = capsulesOf(shapes, body_cell);
  if (!capsules) return refuse(capsules.error());
  return MechanismBodies(axis, std::move(*capsules));
}

Capsules MechanismBodies::at(double value) const {
  arm::Pose frame = axis_.at;
  if (axis_.turns) {
    frame = frame * Eigen::AngleAxisd(value, axis_.direction);
  } else {
    frame = frame * Eigen::Translation3d(value * axis_.direction);
  }
  Capsules capsules;
  capsules.reserve(capsules_.size());
  for (const Capsule& capsule : capsules_) capsules.push_back(placed(frame, capsule));
  return capsules;
}

double MechanismBodies::largestDisplacement(double half_width) const {
  double largest = 0.0;
  for (std::size_t body = 0; body < size(); ++body) {
    largest = std::max(largest, displacementBound(body, half_width));
  }
  return largest;
}

}  // namespace cobot_command::cell
