// Capsules: the bodies of robots, tools and their surroundings. Distances in closed form.
//
// All lengths in [m], in one frame.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/shape.h"

namespace cobot_command::cell {

/// The segment is its core. If both ends are the same point it is a sphere.
using Capsule = CapsuleShape;
using Capsules = std::vector<Capsule>;

/// Edges along the axes of the frame; lower <= upper.
struct AlignedBox {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
};

/// The smallest box around all capsules. Without capsules: `lower` is above `upper`, at infinite distance
/// from all boxes.
[[nodiscard]] AlignedBox boxAround(const Capsules& capsules);

/// The capsule transformed to the frame in which `frame` is given.
[[nodiscard]] Capsule placed(const arm::Pose& frame, const Capsule& capsule);

/// Distance from the point to the segment. A segment may be a point, here and below.
[[nodiscard]] double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& to);

/// Distance between the cores of the capsules, without the radii; 0 if they touch.
[[nodiscard]] double coreDistance(const Capsule& a, const Capsule& b);

/// Distance between the surfaces; negative if the capsules overlap.
[[nodiscard]] double distanceBetween(const Capsule& a, const Capsule& b);

/// A lower bound of the distance between anything in one box and anything in the other. If the boxes overlap,
/// the penetration may have any depth, so the value is minus infinity.
[[nodiscard]] double leastDistance(const AlignedBox& a, const AlignedBox& b);

/// Distance between the core and the box, without the radius; 0 if they touch.
[[nodiscard]] double coreDistance(const Capsule& capsule, const AlignedBox& box);

/// The closest pair of capsules, or the pair with the deepest overlap.
struct Nearest {
  double distance = 0;     ///< between their surfaces
  std::size_t first = 0;   ///< index in the first list
  std::size_t second = 0;  ///< index in the second list
};
/// If several pairs are equally close, the first one. Infinite distance if a list is empty.
[[nodiscard]] Nearest nearestOf(const Capsules& first, const Capsules& second);

}  // namespace cobot_command::cell
