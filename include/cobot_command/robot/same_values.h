// Largest difference between two values of a controller that count as equal: half a step more than its
// precision, because it sends floats.
#pragma once

#include "cobot_command/common/units.h"

namespace cobot_command::robot::same {

inline constexpr double kPlace = mmToM(0.00105);
inline constexpr double kAngle = degToRad(0.00105);
inline constexpr double kMass = 0.00101;      // [kg]
inline constexpr double kInertia = 0.101e-6;  // [kg m^2]

}  // namespace cobot_command::robot::same
