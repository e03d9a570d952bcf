// CBT_MoveAbsolute (thesis 5.3.2): to joints or to a pose, by PTP or along a line.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class AbsoluteFormat : int { Jpp = 0, Cpp = 1, Cpr = 2, Cap = 3, Car = 4 };  ///< Table 5.3.2.5

struct MoveAbsoluteGoal {
  static constexpr const char* kName = "move_absolute";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;        ///< 0: the layer selects a tag; 2..9 as in the thesis
  int movement_command = 1;  ///< Movement
  int data_format = 1;       ///< AbsoluteFormat
  SixValues target{};
  std::optional<FramedPose> target_pose;  ///< replaces `target`, with a Cartesian format
  /// % (0, 100] or mm/s (0, 4500], depending on the format; negative: withDefaults().
  double speed = 0;
  double accel_time = 0;  ///< time to top speed [ms], 150..9999
  bool blending_enable = false;
  double blending_value = 0;                 ///< % 0..100, or mm 0..2000 with a radius format
  bool disable_precise_positioning = false;  ///< as in the controller: false is precise
  bool robot_pose_enable = false;
  std::array<int, 3> robot_pose{0, 2, 4};  ///< Config1..3
  bool exit_node = false;                  ///< leave the Listen node after the motion
  int buffer_mode = 0;                     ///< BufferMode
  bool check_only = false;                 ///< validate and plan; nothing is sent
};

/// nullopt: data_format has no valid value.
[[nodiscard]] std::optional<script::DataFormat> formatOf(const MoveAbsoluteGoal& goal);
[[nodiscard]] GoalTraits traitsOf(const MoveAbsoluteGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveAbsoluteGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const MoveAbsoluteGoal& goal, const FrameFinder& finder);
[[nodiscard]] Order orderOf(const MoveAbsoluteGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
