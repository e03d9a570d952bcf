// Parts that robots carry: on the flange or on other parts, to any depth (doc/cell.md).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// The parent of a part that is not on another part.
inline constexpr const char* kOnFlange = "flange";

struct CarriedPart {
  std::string name;
  std::vector<Shape> shapes;             ///< in the frame of the part
  std::string on = kOnFlange;            ///< kOnFlange, or the name of a part
  arm::Pose at = arm::Pose::Identity();  ///< of the part, in the frame of its parent [m]
};

/// Names of the parts that a robot carries.
using Carried = std::set<std::string>;

/// An immutable value; safe to share between threads.
class PartTree {
 public:
  /// Refused if two parts have the same name, a part has the name of the flange, a parent does not exist,
  /// parts form a cycle, or a shape is invalid.
  [[nodiscard]] static Result<PartTree, BodyRefusal> of(const std::vector<CarriedPart>& parts,
                                                        double body_cell = kUsualBodyCell);

  /// The bodies of the carried parts, by part name. Unknown names are ignored.
  [[nodiscard]] std::vector<FlangeCapsules> bodiesOf(const Carried& carried) const;

 private:
  struct Branch {
    std::string name;
    Capsules capsules;  ///< in the flange [m]
  };

  std::vector<Branch> branches_;  ///< sorted by name
};

}  // namespace cobot_command::cell
