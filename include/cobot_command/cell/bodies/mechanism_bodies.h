// All bodies of a mechanism in a cell, wherever it is along or about its one axis.
//
// A value, immutable after it is made; safe to share between threads.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// How something moves: along a direction, or about a line through the origin of its frame.
struct MotionAxis {
  bool turns = false;                                    ///< about the line [rad]; else along it [m]
  arm::Pose at = arm::Pose::Identity();                  ///< of its frame in the world, at value 0 [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< in that frame, of unit length
};

class MechanismBodies {
 public:
  /// The shapes are seen from the frame that moves. Refused where a shape is none.
  [[nodiscard]] static Result<MechanismBodies, BodyRefusal> of(const MotionAxis& axis,
                                                               const std::vector<Shape>& shapes,
                                                               double body_cell = kUsualBodyCell);
  /// `capsules`: seen from the frame that moves [m].
  MechanismBodies(const MotionAxis& axis, Capsules capsules);

  [[nodiscard]] std::size_t size() const { return capsules_.size(); }
  [[nodiscard]] const MotionAxis& axis() const { return axis_; }
  /// Seen from the frame that moves [m].
  [[nodiscard]] const Capsules& capsules() const { return capsules_; }
  /// Where the bodies are at that value of the axis [m or rad], in the world [m].
  [[nodiscard]] Capsules at(double value) const;

  /// No point of this body is farther [m] than this from where it is at the middle of an interval of the
  /// axis, at any value in it; `half_width`: of the interval [m or rad, not negative].
  [[nodiscard]] double displacementBound(std::size_t body, double half_width) const {
    return reach_[body] * half_width;
  }
  /// The largest of them.
  [[nodiscard]] double largestDisplacement(double half_width) const;

 private:
  MotionAxis axis_;
  Capsules capsules_;          ///< in the frame that moves [m]
  std::vector<double> reach_;  ///< by body: what its fastest point moves per unit of the axis, at most
};

}  // namespace cobot_command::cell
