// CBT_MoveCircle (thesis 5.3.4): an arc from the present position, through the arc point, to the end point.
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
  std::optional<FramedPose> arc_pose;  ///< replaces arc_point
  std::optional<FramedPose> end_pose;  ///< replaces end_point
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;  ///< % 0..100: both formats blend in %
  /// Length of the arc [deg], 0..360. 0: up to the end point, with a rotation to its orientation. Otherwise:
  /// this angle along the circle, with constant orientation.
  double arc_angle = 0;
  bool disable_precise_positioning = false;  ///< as in the controller: false is precise
  bool exit_node = false;
  int buffer_mode = 0;
  bool check_only = false;
};

/// nullopt: data_format has no valid value.
[[nodiscard]] std::optional<script::DataFormat> formatOf(const MoveCircleGoal& goal);
[[nodiscard]] GoalTraits traitsOf(const MoveCircleGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveCircleGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const MoveCircleGoal& goal, const FrameFinder& finder);
[[nodiscard]] Order orderOf(const MoveCircleGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
