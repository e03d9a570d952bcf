// A planned path for display: its course, its rounded corners, and the refused point.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"

namespace cobot_command::path {

/// All positions are in the robot base [m], of the moved frame of their point.
struct PathPreview {
  struct Point {
    int index = 0;          ///< in the array of its goal
    Eigen::Vector3d place;  ///< position of its target
    double blend = 0;  ///< distance from there at which the path is left [m]; 0: the arm stops on the point
  };
  using Line = std::vector<Eigen::Vector3d>;

  std::vector<Point> points;  ///< the planned points, in order
  std::vector<Line> lines;    ///< the path along them; a new line starts where another frame is moved
  std::optional<PathRefusal> refusal;  ///< of the point after these
};

/// From point `first` of the plan to its end.
[[nodiscard]] PathPreview previewOf(const PathPlan& plan, std::size_t first, const arm::ArmModel& arm);

}  // namespace cobot_command::path
