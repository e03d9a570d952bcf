// Parts that robots carry: on the flange or on other parts, to any depth (cell.md, M2).
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

/// What a part is on when it is on no other part.
inline constexpr const char* kOnFlange = "flange";

struct CarriedPart {
  std::string name;
  std::vector<Shape> shapes;             ///< in the frame of the part
  std::string on = kOnFlange;            ///< kOnFlange, or the name of a part
  arm::Pose at = arm::Pose::Identity();  ///< of the part, in the frame of what it is on [m]
};

/// Names of the parts that a robot carries.
using Carried = std::set<std::string>;

/// A value, immutable after it is made; safe to share between threads.
class PartTree {
 public:
  /// Refused when two parts have the same name, one is named as the flange, or is on what does not exist, or
  /// in the end on itself, and where a shape is none.
  [[nodiscard]] static Result<PartTree, BodyRefusal> of(const std::vector<CarriedPart>& parts,
                                                        double body_cell = kUsualBodyCell);

  /// The bodies of what is carried, by the names of the parts. Names of no part are none.
  [[nodiscard]] std::vector<FlangeCapsules> bodiesOf(const Carried& carried) const;

 private:
  struct Branch {
    std::string name;
    Capsules capsules;  ///< in the flange [m]
  };

  std::vector<Branch> branches_;  ///< sorted by name
};

}  // namespace cobot_command::cell
