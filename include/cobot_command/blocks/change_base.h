// CBT_ChangeBase (thesis 5.3.5): the base of the motions that follow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct ChangeBaseGoal {
  static constexpr const char* kName = "change_base";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;                   ///< 0 or 2..9; only echoed
  SixValues transformation{};           ///< the base in the robot base
  std::optional<FramedPose> base_pose;  ///< replaces transformation
  std::string base_name;                ///< replaces both: the name of a base of the project; empty: none
  bool exit_node = false;
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const ChangeBaseGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ChangeBaseGoal& goal);
[[nodiscard]] std::optional<Failure> findMovedFrame(const ChangeBaseGoal& goal, const FrameFinder& finder);
[[nodiscard]] Order orderOf(const ChangeBaseGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
