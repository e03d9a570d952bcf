// What speaks against the numbers of a question, and what its tool and its frame are.
#pragma once

#include <optional>
#include <string_view>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"
#include "cobot_command/kinematics/posture.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

/// Six joints [deg] that are all finite, in rad.
[[nodiscard]] Result<arm::JointVector, Refusal> finiteJoints(const arm::ControllerJoints& joints_deg);
/// And none of them beyond +-100000.
[[nodiscard]] Result<arm::JointVector, Refusal> jointsInRange(const arm::ControllerJoints& joints_deg);
/// `what`: "the pose".
[[nodiscard]] Result<arm::Pose, Refusal> poseInRange(std::string_view what, const arm::ControllerPose& pose);

struct Mounting {
  arm::Pose tool;   ///< in the flange
  arm::Pose frame;  ///< in the robot base
};
[[nodiscard]] Result<Mounting, Refusal> mountingOf(const tables::DataTables& tables,
                                                   const ToolAndFrame& numbers);

}  // namespace cobot_command::kinematics
