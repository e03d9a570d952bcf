// Inverse kinematics: pose of a tool of the tables in a frame of the tables -> all postures that reach it,
// and the chosen one. The robot does not move, and no connection is needed.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"
#include "cobot_command/kinematics/posture.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

/// How the posture is chosen; the numbers are those of SRCI.
enum class Configuration {
  Given = 0,  ///< the posture with the bits of the request
  Same = 1,   ///< the posture with the bits of the joints of the request
  Free = 2  ///< the posture within the limits that is reached first from the joints of the request, at rated
            ///< joint speeds
};

struct InverseQuestion {
  arm::ControllerPose pose{};  ///< of the tool in the frame [mm, deg]
  ToolAndFrame numbers;
  int configuration = 0;             ///< a Configuration as received, not yet checked
  std::array<int, 3> bits{0, 2, 4};  ///< Config1..3, only used with Given
  /// Start of the motion [deg]: each joint gets the nearest turn. It may be outside the limits.
  arm::ControllerJoints joints{};
};

/// One of the postures that bring the tool to the pose.
struct Branch {
  Posture posture;             ///< at the turns nearest to the joints of the request
  std::optional<int> outside;  ///< a joint (0..5) with no turn in its limits; std::nullopt: all have one
};

struct InverseAnswer {
  std::vector<Branch> branches;     ///< at most eight, ordered by their bits; also filled if none was chosen
  Result<Posture, Refusal> chosen;  ///< within the limits
};

/// Refused: a number that is not finite (16#200) or beyond +-100000 (16#213), a tool or a frame without a
/// known pose (16#8D35, 16#8D08), an unknown configuration (16#8D21), invalid bits (16#8D40, 16#8D05,
/// 16#8D41), a pose that no posture reaches, or none with these bits (16#8C62), and a pose reached only
/// outside the limits (16#8C63).
[[nodiscard]] InverseAnswer inverse(const arm::ArmModel& arm, const tables::DataTables& tables,
                                    const InverseQuestion& question);

}  // namespace cobot_command::kinematics
