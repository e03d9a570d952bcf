// Where a TCP is in the flange, of poses of the flange in which it touched one and the same point.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"

namespace cobot_command::kinematics {

inline constexpr std::size_t kFewestTouches = 4;
inline constexpr std::size_t kMostTouches = 100;
/// How far any two poses have to be turned against each other [deg]. Ours.
inline constexpr double kLeastTurn = 5;
/// By how much all of them together have to be turned about each axis, as the root of the mean square of what
/// moves a point at a distance of 1; the errors of the touches grow by its inverse. Ours.
inline constexpr double kLeastSpread = 0.05;
/// Of the touches, where a caller does not say how many [mm]. Ours.
inline constexpr double kUsualError = 5;

struct ToolQuestion {
  std::vector<arm::ControllerPose> flanges;  ///< in one frame, whichever [mm, deg]
  double most_error = 0;  ///< how far a touch may be from the point, 0..100000 [mm]; 0: kUsualError
};

struct ToolAnswer {
  arm::ControllerPose tcp{};    ///< in the flange [mm]; turned as the flange is, as touches tell no turn
  arm::ControllerPose point{};  ///< that was touched, in the frame of the flanges [mm]
  double mean_error = 0;        ///< of the touches from it, root of the mean square [mm]
  double worst_error = 0;       ///< [mm]
};

/// By least squares. Refused: fewer than kFewestTouches (16#8C66), more than kMostTouches (16#8C65), a number
/// that is not finite (16#200) or beyond +-100000 (16#213), two poses that are turned too little against each
/// other (16#8C59), all turned about one axis (16#8C61), a touch that is too far from the point (16#8C60).
[[nodiscard]] Result<ToolAnswer, Refusal> calculateTool(const ToolQuestion& question);

}  // namespace cobot_command::kinematics
