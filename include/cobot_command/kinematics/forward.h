// Forward kinematics: joints -> pose of a tool of the tables in a frame of the tables. The robot does not
// move, and no connection is needed.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"
#include "cobot_command/kinematics/posture.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

struct ForwardQuestion {
  arm::ControllerJoints joints{};  ///< [deg], within the limits of the model
  ToolAndFrame numbers;
};

struct ForwardAnswer {
  arm::ControllerPose pose{};  ///< of the tool in the frame [mm, deg]
  Posture posture;             ///< the given joints, with their bits and turns
};

/// Refused: a joint that is not finite (16#200) or outside its limits (16#8C63), a tool or a frame without a
/// known pose (16#8D35, 16#8D08).
[[nodiscard]] Result<ForwardAnswer, Refusal> forward(const arm::ArmModel& arm,
                                                     const tables::DataTables& tables,
                                                     const ForwardQuestion& question);

}  // namespace cobot_command::kinematics
