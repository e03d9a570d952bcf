// All bodies of a robot in a cell: of its links, its tool, and what it carries, at any joints.
//
// Values; safe to share between threads while nobody changes them.
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
  std::size_t link = 0;  ///< with which it moves: 0, the fixed base, to 6, behind joint 6
  Capsule capsule;       ///< in the frame of that link [m]
  std::string name;      ///< for people: of the link, "tool", or of the part
};

/// It never moves: with the base, or as it only turns about its own axis on it. A robot may stand with such
/// bodies on an obstacle.
[[nodiscard]] bool isFixed(const Body& body);

/// Capsules of one thing in the flange, such as a tool or a part.
struct FlangeCapsules {
  std::string name;
  Capsules capsules;  ///< [m]
};

/// A robot in the world, at certain joints.
struct PlacedRobot {
  Capsules capsules;    ///< one for each body, in their order [m]
  arm::JointAxes axes;  ///< [m]
};

class RobotBodies {
 public:
  /// An arm from the text of its URDF, its base in the world [m], and its tool in the flange. First come the
  /// bodies of the links, then those of the tool. Refused where the URDF is, where one of its bodies is no
  /// primitive (a mesh), and where the tool has a wrong shape.
  [[nodiscard]] static Result<RobotBodies, BodyRefusal> fromUrdf(const std::string& urdf,
                                                                 const arm::Pose& base,
                                                                 const std::vector<Shape>& tool,
                                                                 double body_cell = kUsualBodyCell);

  /// The same robot that carries these in addition to what it has; they come behind the other bodies.
  [[nodiscard]] RobotBodies carrying(const std::vector<FlangeCapsules>& carried) const;

  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] const arm::Pose& base() const { return base_; }
  [[nodiscard]] const arm::LinkChain& chain() const { return chain_; }

  /// Where the bodies are at these joints [rad], and the axes of the joints; all in the world [m].
  [[nodiscard]] PlacedRobot at(const arm::JointVector& joints) const;
  /// The same into what is there already, so that no memory is allocated again.
  void place(const arm::JointVector& joints, PlacedRobot& placed) const;

 private:
  RobotBodies(const arm::ArmModel& arm, const arm::Pose& base);

  void addAtFlange(const FlangeCapsules& things);

  arm::LinkChain chain_;
  arm::Pose base_;
  std::vector<Body> bodies_;
};

}  // namespace cobot_command::cell
