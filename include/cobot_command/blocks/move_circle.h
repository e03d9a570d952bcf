// CBT_MoveCircle (thesis 5.3.4): an arc from where the robot is, through the arc point, to the end point.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class CircleFormat : int { Cpp = 0, Cap = 1 };  ///< Table 5.3.4.4

struct MoveCircleGoal {
  static constexpr const char* kName = "move_circle";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;
  int data_format = 0;  ///< CircleFormat
  SixValues arc_point{};
  SixValues end_point{};
  std::optional<FramedPose> arc_pose;  ///< in place of arc_point
  std::optional<FramedPose> end_pose;  ///< in place of end_point
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;  ///< % 0..100: both formats blend in %
  /// Length of the arc [deg], 0..360. 0: to the end point, turning to its orientation; else this far along
  /// the circle, the orientation held.
  double arc_angle = 0;
  bool disable_precise_positioning = false;  ///< the controller's own sense: false is precise
  bool exit_node = false;
  int buffer_mode = 0;
  bool check_only = false;
};

/// Nothing: its number is of none.
[[nodiscard]] std::optional<script::DataFormat> formatOf(const MoveCircleGoal& goal);
[[nodiscard]] GoalTraits traitsOf(const MoveCircleGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveCircleGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const MoveCircleGoal& goal, const FrameFinder& finder);
[[nodiscard]] Order orderOf(const MoveCircleGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
