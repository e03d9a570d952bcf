// All bodies of a mechanism in a cell, at any position of its axis.
//
// An immutable value; safe to share between threads.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Axis of motion: along a direction, or about a line through the origin of its frame.
struct MotionAxis {
  bool turns = false;                                    ///< true: about the line [rad]; false: along it [m]
  arm::Pose at = arm::Pose::Identity();                  ///< its frame in the world, at value 0 [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< in that frame, unit vector
};

class MechanismBodies {
 public:
  /// The shapes are in the moving frame. Refused if a shape is invalid.
  [[nodiscard]] static Result<MechanismBodies, BodyRefusal> of(const MotionAxis& axis,
                                                               const std::vector<Shape>& shapes,
                                                               double body_cell = kUsualBodyCell);
  /// `capsules`: in the moving frame [m].
  MechanismBodies(const MotionAxis& axis, Capsules capsules);

  [[nodiscard]] std::size_t size() const { return capsules_.size(); }
  [[nodiscard]] const MotionAxis& axis() const { return axis_; }
  /// In the moving frame [m].
  [[nodiscard]] const Capsules& capsules() const { return capsules_; }
  /// The bodies at that value of the axis [m or rad], in the world [m].
  [[nodiscard]] Capsules at(double value) const;

  /// Largest distance [m] of any point of this body from its position at the middle of an axis interval, for
  /// all values in the interval. `half_width`: of the interval [m or rad, not negative].
  [[nodiscard]] double displacementBound(std::size_t body, double half_width) const {
    return reach_[body] * half_width;
  }
  /// The largest bound of all bodies.
  [[nodiscard]] double largestDisplacement(double half_width) const;

 private:
  MotionAxis axis_;
  Capsules capsules_;          ///< in the moving frame [m]
  std::vector<double> reach_;  ///< by body: largest displacement of a point per unit of the axis
};

}  // namespace cobot_command::cell
