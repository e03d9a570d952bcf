// What a check has found: the motion, or where it cannot be made and why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cobot_command/StepReport.h>
#include <cobot_command/Transformation.h>
#include <trajectory_msgs/JointTrajectory.h>

namespace cobot_command::rviz_plugin {

struct Plan {
  trajectory_msgs::JointTrajectory path;  ///< [rad] from its start; empty: not told
  std::optional<cobot_command::Transformation>
      offending;       ///< the first point that cannot be: TCP in the active base
  std::string reason;  ///< why it cannot be
};

/// Of steps that follow one another.
[[nodiscard]] Plan planOf(const std::vector<cobot_command::StepReport>& steps);

}  // namespace cobot_command::rviz_plugin
