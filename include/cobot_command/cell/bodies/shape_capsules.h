// Converts shapes to capsules (doc/cell.md). The capsules contain the whole shape.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Default of the largest radius of the capsules that cover a box [m].
inline constexpr double kUsualBodyCell = 0.030;
/// A box that needs more capsules is refused.
inline constexpr double kMostCapsulesOfBox = 4096;

/// Why bodies cannot be created: what was found, what is allowed, what to do.
struct BodyRefusal {
  std::string message;
};

/// The capsules of one shape, in the frame of the shape's `at` [m].
///
/// A cylinder becomes one capsule whose core is the axis over the full length. A box becomes parallel
/// capsules along its longest edge: the cross-section is divided into the fewest equal cells whose half
/// diagonal is at most `body_cell` [m, above 0]. The half diagonal is the radius, and the cores have the full
/// length of the edge. Refused if a length is not finite or is negative, a radius is not above 0, or a box
/// needs more than kMostCapsulesOfBox.
[[nodiscard]] Result<Capsules, BodyRefusal> capsulesOf(const Shape& shape, double body_cell = kUsualBodyCell);

/// The capsules of all shapes, concatenated.
[[nodiscard]] Result<Capsules, BodyRefusal> capsulesOf(const std::vector<Shape>& shapes,
                                                       double body_cell = kUsualBodyCell);

}  // namespace cobot_command::cell
