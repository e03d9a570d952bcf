// A frame of three points that a tool has touched: its origin, one on its x axis, one in its xy plane.
#pragma once

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::kinematics {

/// How far points have to be from each other, and the last one from the line of the others [mm]: nearer by,
/// the play of an arm turns the frame by more than half a degree. Ours.
inline constexpr double kLeastDistance = 10;

struct FrameQuestion {
  // Where the tool was; of each only x, y and z count.
  arm::ControllerPose origin{};
  arm::ControllerPose on_x_axis{};    ///< where x is above 0
  arm::ControllerPose in_xy_plane{};  ///< where y is above 0
  int frame = 0;                      ///< number of the frame in which they are
  int reference = 0;                  ///< number of the frame in which the new one shall stand
};

/// The new frame in its reference [mm, deg]. Refused: a number that is not finite (16#200) or beyond +-100000
/// (16#213), a frame without a known pose (16#8D08), points that are nearer than kLeastDistance (16#8C59), or
/// on one line (16#8C61).
[[nodiscard]] Result<arm::ControllerPose, Refusal> calculateFrame(const tables::DataTables& tables,
                                                                  const FrameQuestion& question);

}  // namespace cobot_command::kinematics
