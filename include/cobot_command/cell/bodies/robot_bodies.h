// All bodies of a robot in a cell, at any joints: links, tool, and carried parts.
//
// Values; safe to share between threads as long as no thread changes them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/link_chain.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// One capsule of a robot.
struct Body {
  std::size_t link = 0;  ///< link that it moves with: 0, the fixed base, to 6, after joint 6
  Capsule capsule;       ///< in the frame of that link [m]
  std::string name;      ///< for display: of the link, "tool", or of the part
};

/// True if the body never moves: it belongs to the base, or only rotates about its own axis on it. Such
/// bodies may stand on an obstacle.
[[nodiscard]] bool isFixed(const Body& body);

/// Capsules of one object in the flange, such as a tool or a part.
struct FlangeCapsules {
  std::string name;
  Capsules capsules;  ///< [m]
};

/// A robot in the world at given joints.
struct PlacedRobot {
  Capsules capsules;    ///< one per body, in their order [m]
  arm::JointAxes axes;  ///< [m]
};

class RobotBodies {
 public:
  /// Creates a robot from the text of its URDF, its base in the world [m], and its tool in the flange. The
  /// bodies of the links are first, then those of the tool. Refused if the URDF is invalid, a body is not a
  /// primitive (a mesh), or the tool has an invalid shape.
  [[nodiscard]] static Result<RobotBodies, BodyRefusal> fromUrdf(const std::string& urdf,
                                                                 const arm::Pose& base,
                                                                 const std::vector<Shape>& tool,
                                                                 double body_cell = kUsualBodyCell);

  /// The same robot that also carries these objects; their bodies are after the others.
  [[nodiscard]] RobotBodies carrying(const std::vector<FlangeCapsules>& carried) const;

  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] const arm::Pose& base() const { return base_; }
  [[nodiscard]] const arm::LinkChain& chain() const { return chain_; }

  /// The bodies and the joint axes at these joints [rad], in the world [m].
  [[nodiscard]] PlacedRobot at(const arm::JointVector& joints) const;
  /// As at(), but reuses the memory of `placed`.
  void place(const arm::JointVector& joints, PlacedRobot& placed) const;

 private:
  RobotBodies(const arm::ArmModel& arm, const arm::Pose& base);

  void addAtFlange(const FlangeCapsules& things);

  arm::LinkChain chain_;
  arm::Pose base_;
  std::vector<Body> bodies_;
};

}  // namespace cobot_command::cell
