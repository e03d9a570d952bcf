#include "cobot_command/cell/sweep/displacement.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::cell {
namespace {

double squaredDistanceToAxis(const Eigen::Vector3d& point, const arm::JointAxis& axis) {
  return axis.direction.cross(point - axis.origin).squaredNorm();
}

/// Of the farthest point. The distance from a line is convex, so of the core it is an end.
double farthestFrom(const arm::JointAxis& axis, const Capsule& capsule) {
  const double from = squaredDistanceToAxis(capsule.from, axis);
  const double to = squaredDistanceToAxis(capsule.to, axis);
  return std::sqrt(std::max(from, to)) + capsule.radius;
}

}  // namespace

double displacementBound(const Capsule& capsule, std::size_t link, const arm::JointAxes& axes,
                         const arm::JointVector& half_widths) {
  // What the joints behind do to the body. How far it is from an axis depends on them alone, so that it is no
  // farther from it than at the centre and that.
  double moved = 0;
  for (std::size_t i = link; i-- > 0;) {
    const double lever = farthestFrom(axes[i], capsule) + moved;
    moved += lever * half_widths[static_cast<Eigen::Index>(i)];
  }
  return moved;
}

double largestDisplacement(const RobotBodies& robot, const PlacedRobot& placed,
                           const arm::JointVector& half_widths) {
  double largest = 0;
  for (std::size_t i = 0; i < robot.bodies().size(); ++i) {
    const std::size_t link = robot.bodies()[i].link;
    largest = std::max(largest, displacementBound(placed.capsules[i], link, placed.axes, half_widths));
  }
  return largest;
}

}  // namespace cobot_command::cell
