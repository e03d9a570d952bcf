// Shapes as capsules (cell.md, M6): each capsule list contains the whole shape.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// The greatest radius of the capsules that cover a box, where nobody says otherwise [m].
inline constexpr double kUsualBodyCell = 0.030;
/// Above this many capsules a box is refused.
inline constexpr double kMostCapsulesOfBox = 4096;

/// Why there are no bodies: what was found, what is allowed, what to do.
struct BodyRefusal {
  std::string message;
};

/// The capsules of one shape, in the frame in which the shape's `at` is [m].
///
/// A cylinder becomes one capsule, its core the axis over the full length. A box becomes parallel capsules
/// along its longest edge: the cross-section is cut into the fewest equal cells with half a diagonal of at
/// most `body_cell` [m, above 0], which is their radius, and the cores have the full length of the edge.
/// Refused when a length is not finite, or is negative, a radius is not above 0, or a box needs more than
/// kMostCapsulesOfBox.
[[nodiscard]] Result<Capsules, BodyRefusal> capsulesOf(const Shape& shape, double body_cell = kUsualBodyCell);

/// Of all of them, one behind the other.
[[nodiscard]] Result<Capsules, BodyRefusal> capsulesOf(const std::vector<Shape>& shapes,
                                                       double body_cell = kUsualBodyCell);

}  // namespace cobot_command::cell
