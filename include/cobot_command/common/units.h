// The one place where the controller's mm, degrees and percent become SI (m, rad, shares) and back.
#pragma once

namespace cobot_command {

inline constexpr double kPi = 3.14159265358979323846;

[[nodiscard]] constexpr double degToRad(double degrees) {
  return degrees * (kPi / 180.0);
}
[[nodiscard]] constexpr double radToDeg(double radians) {
  return radians * (180.0 / kPi);
}
[[nodiscard]] constexpr double mmToM(double millimetres) {
  return millimetres * 1e-3;
}
[[nodiscard]] constexpr double mToMm(double metres) {
  return metres * 1e3;
}

/// Of moments of inertia [kg mm^2], in as many kg m^2.
inline constexpr double kMm2PerM2 = 1e6;

/// Of a share, 0 to 1, in as many of it.
inline constexpr double kPercent = 100;

}  // namespace cobot_command
