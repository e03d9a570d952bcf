// Moving back along a driven path, and forward again: finds the place of the arm on the path, and generates
// the motion from there as a PVT.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/path/driven_path.h"

namespace cobot_command::path {

/// The place on the path at which the joints are (DrivenPath::kSamePlace). Of several places it is the one
/// nearest in time to the last place of the robot; the search extends to DrivenPath::farthest().
/// std::nullopt: no such place, or `give_up`, which is polled, returned true.
[[nodiscard]] std::optional<Duration> placeOn(const DrivenPath& driven, const arm::JointVector& joints,
                                              const std::function<bool()>& give_up = {});

/// If no place is found: the distance to the nearest place that was checked (every 10 ms, or 2000 places of a
/// long path), as the joint with the largest deviation.
struct WayMiss {
  int joint = 0;   ///< 0..5
  double gap = 0;  ///< [rad]
};
/// Precondition: not empty.
[[nodiscard]] WayMiss missOf(const DrivenPath& driven, const arm::JointVector& joints);

/// The motion between two places, in either direction. It follows the geometry of the plans with another
/// timing: it accelerates from rest within half a second to `rate` times their speeds, and decelerates
/// likewise, also at each cut (DrivenPath::Cut). On a short path it only reaches the speed that this permits.
struct Retrace {
  Duration from{};
  Duration to{};
  double rate = 0.25;                   ///< [kLeastRetraceRate, 1]
  arm::JointVector start;               ///< joints of the arm, at `from` or near it [rad]
  std::optional<arm::JointVector> end;  ///< target joints; std::nullopt: at `to`
};
/// 1 % of an override of 1 %.
constexpr double kLeastRetraceRate = 1e-4;

[[nodiscard]] Duration durationOf(const Retrace& retrace, const DrivenPath& driven);
/// In segments of whole milliseconds, at least 25. std::nullopt: more than `most` would be needed.
[[nodiscard]] std::optional<std::vector<motion::PvtJointPoint>> pvtOf(const Retrace& retrace,
                                                                      const DrivenPath& driven,
                                                                      std::size_t most);

}  // namespace cobot_command::path
