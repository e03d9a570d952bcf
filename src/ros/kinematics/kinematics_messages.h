// Questions of the kinematics and their answers <-> messages.
#pragma once

#include "cobot_command/CalculateFrame.h"
#include "cobot_command/CalculateTool.h"
#include "cobot_command/ForwardKinematics.h"
#include "cobot_command/InverseKinematics.h"
#include "cobot_command/kinematics/calculate_frame.h"
#include "cobot_command/kinematics/calculate_tool.h"
#include "cobot_command/kinematics/forward.h"
#include "cobot_command/kinematics/inverse.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] kinematics::ForwardQuestion toQuestion(
    const cobot_command::ForwardKinematics::Request& request);
[[nodiscard]] kinematics::InverseQuestion toQuestion(
    const cobot_command::InverseKinematics::Request& request);
[[nodiscard]] kinematics::FrameQuestion toQuestion(const cobot_command::CalculateFrame::Request& request);
[[nodiscard]] kinematics::ToolQuestion toQuestion(const cobot_command::CalculateTool::Request& request);

[[nodiscard]] cobot_command::ForwardKinematics::Response toResponse(
    const Result<kinematics::ForwardAnswer, kinematics::Refusal>& answer);
[[nodiscard]] cobot_command::InverseKinematics::Response toResponse(const kinematics::InverseAnswer& answer);
[[nodiscard]] cobot_command::CalculateFrame::Response toResponse(
    const Result<arm::ControllerPose, kinematics::Refusal>& answer);
[[nodiscard]] cobot_command::CalculateTool::Response toResponse(
    const Result<kinematics::ToolAnswer, kinematics::Refusal>& answer);

}  // namespace cobot_command::ros_adapter
