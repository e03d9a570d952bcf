// Converts the controller's mm, degrees and percent to SI (m, rad, ratios) and back. No other file does.
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

/// kg mm^2 in one kg m^2 (moment of inertia).
inline constexpr double kMm2PerM2 = 1e6;

/// Percent in a ratio of 1.
inline constexpr double kPercent = 100;

}  // namespace cobot_command
