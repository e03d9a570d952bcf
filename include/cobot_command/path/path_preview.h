// A planned path as people are to see it: where it goes, how its corners are cut, and the point that refuses
// it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::path {

/// All places are in the robot base [m], of the moved frame of their point.
struct PathPreview {
  struct Point {
    int index = 0;          ///< in the array of its goal
    Eigen::Vector3d place;  ///< of its target
    double blend = 0;       ///< so far from there the path is left [m]; 0: the arm rests on the point
  };
  using Line = std::vector<Eigen::Vector3d>;

  std::vector<Point> points;  ///< that are planned, in their order
  std::vector<Line> lines;    ///< the way along them; another one begins where another frame is moved
  std::optional<PathRefusal> refusal;  ///< of the point behind these
};

/// From that point of the plan to its end.
[[nodiscard]] PathPreview previewOf(const PathPlan& plan, std::size_t first, const arm::ArmModel& arm);

}  // namespace cobot_command::path
