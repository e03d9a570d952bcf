// What tm_arm answers to six numbers: the sentence, the table or the JSON, and whether it is a positive
// answer.
#pragma once

#include <array>
#include <string>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::tm_arm {

struct Answer {
  std::string text;  ///< lines, without the last line end
  bool positive = true;
};

/// Joints [deg] to the pose of the flange [mm, deg] with its pose bits.
[[nodiscard]] Answer forward(const arm::ArmModel& arm, const std::array<double, 6>& joints_deg, bool json);

/// Pose of the flange [mm, deg] to all postures that reach it. Negative when there is none.
[[nodiscard]] Answer inverse(const arm::ArmModel& arm, const std::array<double, 6>& pose_mm_deg, bool json);

}  // namespace cobot_command::tm_arm
