// CBT_MoveRelative (thesis 5.3.3): a move relative to the position of the robot at its start.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

/// Table 5.3.3.5
enum class RelativeFormat : int {
  Jpp = 0,
  Cpp = 1,
  Cpr = 2,
  Cap = 3,
  Car = 4,
  Tpp = 5,
  Tpr = 6,
  Tap = 7,
  Tar = 8
};

struct MoveRelativeGoal {
  static constexpr const char* kName = "move_relative";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;
  int movement_command = 1;  ///< Movement
  int data_format = 1;       ///< RelativeFormat: joints, along the active base (C..) or the tool (T..)
  SixValues target{};        ///< the offset
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;
  bool disable_precise_positioning = false;  ///< as in the controller: false is precise
  bool exit_node = false;
  int buffer_mode = 0;
  bool check_only = false;
};

/// nullopt: data_format has no valid value.
[[nodiscard]] std::optional<script::DataFormat> formatOf(const MoveRelativeGoal& goal);
[[nodiscard]] GoalTraits traitsOf(const MoveRelativeGoal& goal);
[[nodiscard]] std::vector<Failure> check(const MoveRelativeGoal& goal);
[[nodiscard]] Order orderOf(const MoveRelativeGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
