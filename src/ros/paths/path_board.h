// The paths that people are shown: of all goals under way, and of what was planned last.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/path/path_preview.h"

namespace cobot_command::ros_adapter {

class PathBoard {
 public:
  struct Shown {
    blocks::GoalId goal = 0;
    path::PathPreview preview;
    int active = -1;  ///< index of the point that moves the robot; -1: none
    bool ended = false;
  };

  /// In place of what it was before, and of all that have ended.
  void show(blocks::GoalId goal, path::PathPreview preview);
  /// That one of its points moves the robot; -1: none.
  void setActive(blocks::GoalId goal, int index);
  /// It is shown until something else is.
  void end(blocks::GoalId goal);
  void dropEnded();

  /// In the order in which they came.
  [[nodiscard]] const std::vector<Shown>& shown() const { return shown_; }
  /// The point that moves the robot, while two goals blend that of the outgoing one.
  [[nodiscard]] std::optional<Eigen::Vector3d> activePlace() const;

 private:
  [[nodiscard]] Shown* find(blocks::GoalId goal);

  std::vector<Shown> shown_;
};

}  // namespace cobot_command::ros_adapter
