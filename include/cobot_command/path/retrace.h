// Driving back along a path, and forth again: where on it the arm stands, and its way from there as a PVT.
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

/// Of the places on the way that the joints are at (DrivenPath::kSamePlace) the one that is nearest to where
/// the robot was last, by its time; it may have come up to some seconds further. Nothing: it is at none, or
/// `give_up`, asked now and then, said true.
[[nodiscard]] std::optional<Duration> placeOn(const DrivenPath& driven, const arm::JointVector& joints,
                                              const std::function<bool()>& give_up = {});

/// Where no place is: how far the joints are from the nearest one that was looked at (every 10 ms, or at 2000
/// places of a long way), as the joint that is farthest off.
struct WayMiss {
  int joint = 0;   ///< 0..5
  double gap = 0;  ///< [rad]
};
/// Precondition: it is not empty.
[[nodiscard]] WayMiss missOf(const DrivenPath& driven, const arm::JointVector& joints);

/// The way between two places, in either direction. It is that of the plans, only its time is another one:
/// from rest to `rate` of their speeds within half a second, and so to rest again, also where the path was
/// cut (DrivenPath::Cut); a short way no faster than that takes it.
struct Retrace {
  Duration from{};
  Duration to{};
  double rate = 0.25;                   ///< [kLeastRetraceRate, 1]
  arm::JointVector start;               ///< where the arm stands, at `from` or next to it [rad]
  std::optional<arm::JointVector> end;  ///< where it is to stand; nothing: at `to`
};
/// 1 % of an override of 1 %.
constexpr double kLeastRetraceRate = 1e-4;

[[nodiscard]] Duration durationOf(const Retrace& retrace, const DrivenPath& driven);
/// In segments of whole milliseconds, 25 at least. Nothing: these would be more than `most`.
[[nodiscard]] std::optional<std::vector<motion::PvtJointPoint>> pvtOf(const Retrace& retrace,
                                                                      const DrivenPath& driven,
                                                                      std::size_t most);

}  // namespace cobot_command::path
