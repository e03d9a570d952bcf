// Calculates a TCP in the flange from flange poses in which it touched the same point.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/kinematics/kinematics_refusal.h"

namespace cobot_command::kinematics {

inline constexpr std::size_t kFewestTouches = 4;
inline constexpr std::size_t kMostTouches = 100;
/// Smallest rotation between any two poses [deg]. Chosen by this package.
inline constexpr double kLeastTurn = 5;
/// Smallest spread of the orientations about each axis: the RMS displacement of a point at a distance of 1
/// due to the rotations. The errors of the touches are amplified by its inverse. Chosen by this package.
inline constexpr double kLeastSpread = 0.05;
/// Permitted error of the touches if the caller gives none [mm]. Chosen by this package.
inline constexpr double kUsualError = 5;

struct ToolQuestion {
  std::vector<arm::ControllerPose> flanges;  ///< all in the same frame, which may be any [mm, deg]
  double most_error = 0;  ///< largest distance of a touch from the point, 0..100000 [mm]; 0: kUsualError
};

struct ToolAnswer {
  arm::ControllerPose tcp{};  ///< in the flange [mm]; orientation of the flange: touches do not determine it
  arm::ControllerPose point{};  ///< the touched point, in the frame of the flanges [mm]
  double mean_error = 0;        ///< RMS distance of the touches from the point [mm]
  double worst_error = 0;       ///< largest distance [mm]
};

/// Least squares. Refused: fewer than kFewestTouches (16#8C66), more than kMostTouches (16#8C65), a number
/// that is not finite (16#200) or beyond +-100000 (16#213), two poses with too little rotation between them
/// (16#8C59), all rotations about one axis (16#8C61), a touch too far from the point (16#8C60).
[[nodiscard]] Result<ToolAnswer, Refusal> calculateTool(const ToolQuestion& question);

}  // namespace cobot_command::kinematics
