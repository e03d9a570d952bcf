// Calculates a frame from three touched points: its origin, one on its x axis, one in its xy plane.
#pragma once

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

/// Smallest distance between the points, and of the last one from the line through the others [mm]. Below it,
/// the play of an arm rotates the frame by more than half a degree. Chosen by this package.
inline constexpr double kLeastDistance = 10;

struct FrameQuestion {
  // Positions of the tool; only x, y and z are used.
  arm::ControllerPose origin{};
  arm::ControllerPose on_x_axis{};    ///< at positive x
  arm::ControllerPose in_xy_plane{};  ///< at positive y
  int frame = 0;                      ///< number of the frame of these positions
  int reference = 0;                  ///< number of the reference of the new frame
};

/// The new frame in its reference [mm, deg]. Refused: a number that is not finite (16#200) or beyond +-100000
/// (16#213), a frame without a known pose (16#8D08), points closer than kLeastDistance (16#8C59) or on one
/// line (16#8C61).
[[nodiscard]] Result<arm::ControllerPose, Refusal> calculateFrame(const tables::DataTables& tables,
                                                                  const FrameQuestion& question);

}  // namespace cobot_command::kinematics
