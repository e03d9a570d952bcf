// How far values may be apart that a controller has told, and count as the same all the same: half a step
// more than the contract has them, as it tells floats.
#pragma once

#include "cobot_command/common/units.h"

namespace cobot_command::robot::same {

inline constexpr double kPlace = mmToM(0.00105);
inline constexpr double kAngle = degToRad(0.00105);
inline constexpr double kMass = 0.00101;      // [kg]
inline constexpr double kInertia = 0.101e-6;  // [kg m^2]

}  // namespace cobot_command::robot::same
