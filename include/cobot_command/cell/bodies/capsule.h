// Capsules: all that the robots, their tools and what stands around them consist of. Distances in closed
// form.
//
// All of [m], in one frame.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/shape.h"

namespace cobot_command::cell {

/// The segment is its core. Both ends may be the same point: a sphere.
using Capsule = CapsuleShape;
using Capsules = std::vector<Capsule>;

/// Edges along the axes of the frame; no corner of `lower` is above that of `upper`.
struct AlignedBox {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
};

/// The smallest one around all capsules. Of none: `lower` is above `upper`, infinitely far from all boxes.
[[nodiscard]] AlignedBox boxAround(const Capsules& capsules);

/// The same capsule seen from where `frame` is told.
[[nodiscard]] Capsule placed(const arm::Pose& frame, const Capsule& capsule);

/// From the point to the segment. A segment may be a point, here and below.
[[nodiscard]] double distanceToSegment(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& to);

/// Between the cores of the capsules, whatever the radii; 0 where they touch.
[[nodiscard]] double coreDistance(const Capsule& a, const Capsule& b);

/// Between the surfaces; negative where the capsules reach into each other.
[[nodiscard]] double distanceBetween(const Capsule& a, const Capsule& b);

/// What is in one is no closer to what is in the other. Where the boxes meet, it may be in it by any depth:
/// less than any number.
[[nodiscard]] double leastDistance(const AlignedBox& a, const AlignedBox& b);

/// Between the core and the box, whatever the radius; 0 where they touch.
[[nodiscard]] double coreDistance(const Capsule& capsule, const AlignedBox& box);

/// The two that are closest to each other, or deepest in each other.
struct Nearest {
  double distance = 0;     ///< between their surfaces
  std::size_t first = 0;   ///< of the first list
  std::size_t second = 0;  ///< of the second list
};
/// The first such pair where several are as close. Infinitely far where a list is empty.
[[nodiscard]] Nearest nearestOf(const Capsules& first, const Capsules& second);

}  // namespace cobot_command::cell
