// What was planned, as messages: the path of the joints, the report of a step.
#pragma once

#include <vector>

#include <trajectory_msgs/JointTrajectory.h>

#include "cobot_command/StepReport.h"
#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/blocks/shared/sequence_report.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

/// Its stamp is zero: it is a plan, at no time of its own. Wholly empty without a point.
[[nodiscard]] trajectory_msgs::JointTrajectory toMessage(const std::vector<blocks::JointPathPoint>& path,
                                                         const JointNames& names);
[[nodiscard]] cobot_command::StepReport toMessage(const blocks::StepReport& report, const JointNames& names);

}  // namespace cobot_command::ros_adapter
