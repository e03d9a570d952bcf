// What the way into SI and back rounds away is not shown.
#pragma once

#include <array>
#include <cmath>

namespace cobot_command::kinematics {

/// To 1e-9 mm and degrees, and never -0.
inline std::array<double, 6> shown(std::array<double, 6> numbers) {
  constexpr double kPerUnit = 1e9;
  for (double& number : numbers) number = std::round(number * kPerUnit) / kPerUnit + 0.0;
  return numbers;
}

}  // namespace cobot_command::kinematics
