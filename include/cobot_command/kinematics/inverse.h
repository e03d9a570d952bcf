// Where a tool of the tables shall be in a frame of them -> all postures that bring it there, and one of
// them. Nothing moves, and no link is needed.
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

/// Which posture is chosen; the numbers are SRCI's.
enum class Configuration {
  Given = 0,  ///< the one with the bits of the question
  Same = 1,   ///< the one with the bits of the joints of the question
  Free = 2    ///< of those within the limits the one that the joints of the question reach first
};

struct InverseQuestion {
  arm::ControllerPose pose{};  ///< of the tool in the frame [mm, deg]
  ToolAndFrame numbers;
  int configuration = 0;             ///< a Configuration, as a caller gives it
  std::array<int, 3> bits{0, 2, 4};  ///< Config1..3, read with Given only
  /// From where the arm would come [deg]: each joint gets the turn nearest to it. It need not be within the
  /// limits.
  arm::ControllerJoints joints{};
};

/// One of the postures that bring the tool to the pose.
struct Branch {
  Posture posture;             ///< at the turns nearest to the joints of the question
  std::optional<int> outside;  ///< a joint (0..5) without a turn within its limits; nothing: all have one
};

struct InverseAnswer {
  std::vector<Branch> branches;     ///< at most eight, by their bits; also where none of them was chosen
  Result<Posture, Refusal> chosen;  ///< within the limits
};

/// Refused: a number that is not finite (16#200) or beyond +-100000 (16#213), a tool or a frame without a
/// known pose (16#8D35, 16#8D08), an unknown configuration (16#8D21), bits that are none (16#8D40, 16#8D05,
/// 16#8D41), a pose that no posture reaches, or none with these bits (16#8C62), and one that is reached
/// outside the limits only (16#8C63).
[[nodiscard]] InverseAnswer inverse(const arm::ArmModel& arm, const tables::DataTables& tables,
                                    const InverseQuestion& question);

}  // namespace cobot_command::kinematics
