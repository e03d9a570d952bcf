// The text of a cell of any number of robots in a ring: each reaches into the space of the one before it and
// of the one behind it, and books the second of these zones while it holds the first. All of them at once
// would block each other.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace cobot_command::trial {

/// TM5-900 that look inwards, each with a bar across that is as long as they are apart where they work.
/// Precondition: at least eight.
[[nodiscard]] inline std::string ringCell(int robots) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr double kApart = 1100.0;  // where they work [mm]
  constexpr double kReach = 700.0;   // so far from their bases [mm]
  const double radius = kApart / (2.0 * std::sin(kPi / robots)) + kReach * std::cos(kPi / robots);
  std::string bases;
  std::string stations;
  std::string programs;
  for (int robot = 0; robot < robots; ++robot) {
    const double angle = 2.0 * kPi * robot / robots;
    const std::string name = fmt::format("R{}", robot + 1);
    bases += fmt::format(
        "  {}: {{model: tm5-900, base: [{:.3f}, {:.3f}, 0, 0, 0, {:.6f}], home: HOME, tool: {}}}\n", name,
        radius * std::cos(angle), radius * std::sin(angle), angle * 180.0 / kPi - 180.0,
        robot == 0 ? "&bar [{capsule: {from: [-460, 0, 80], to: [460, 0, 80], radius: 30}}]" : "*bar");
    stations +=
        fmt::format("  {}: {}\n", name,
                    robot == 0 ? "&stations {HOME: [0, -60, 140, 10, 90, 0], LEFT: [15, 30, 75, -15, 90, 0], "
                                 "RIGHT: [-15, 30, 75, -15, 90, 0]}"
                               : "*stations");
    programs += fmt::format("  {}: {}\n", name,
                            robot == 0 ? R"(&program
    - path: OUT
      from: HOME
      to: RIGHT
      steps:
        - {movement_command: PTP, data_format: JPP, target_position: LEFT, speed: 50, accel_time: 200}
        - {movement_command: PTP, data_format: JPP, target_position: RIGHT, speed: 50, accel_time: 200}
    - path: BACK
      from: RIGHT
      to: HOME
      steps: [{movement_command: PTP, data_format: JPP, target_position: HOME, speed: 50, accel_time: 200}])"
                                       : "*program");
  }
  return fmt::format(
      "cell: ring\nparameters: {{voxel: 40, step_bound: 20, max_states: 100000, wait_timeout: "
      "3600}}\nrobots:\n{}"
      "stations:\n{}programs:\n{}",
      bases, stations, programs);
}

}  // namespace cobot_command::trial
