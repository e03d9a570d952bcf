#include "path_corner.h"

#include <algorithm>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/blend.h"

namespace cobot_command::path {
namespace {

constexpr Duration kCornerStep = std::chrono::milliseconds(1);
constexpr double kNoWay = 1e-9;  // [m]

/// Below which share of a move in joint space the moved frame is within `metres` of where it began.
double shareWithin(const PlannedPoint& move, const arm::Pose& moved_frame, double metres,
                   const arm::ArmModel& arm) {
  const arm::JointVector from = move.motion->at(Duration::zero()).position;
  const arm::JointVector way = move.motion->end().position - from;
  const auto place_at = [&](double share) -> Eigen::Vector3d {
    return (arm::forwardKinematics(arm, from + share * way) * moved_frame).translation();
  };
  const Eigen::Vector3d corner = place_at(0.0);
  constexpr int kSteps = 64;
  int steps = 1;
  const auto is_within = [&](double share) { return (place_at(share) - corner).norm() <= metres; };
  while (steps <= kSteps && is_within(static_cast<double>(steps) / kSteps)) ++steps;
  if (steps > kSteps) return 1.0;
  double within = static_cast<double>(steps - 1) / kSteps;
  double beyond = static_cast<double>(steps) / kSteps;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (within + beyond);
    (is_within(middle) ? within : beyond) = middle;
  }
  return within;
}

/// Of a way in mm; a turn on the spot leaves nothing of a way out.
double shareOfWay(const PlannedPoint& move, double metres) {
  const double way = move.motion->tcpWay();
  return way < kNoWay ? 1.0 : std::min(1.0, metres / way);
}

motion::BlendWay blendOf(const PlannedPoint& before, const PlannedPoint& next, const PathScene& scene) {
  const double tolerance = before.point.command_tolerance;
  if (is(before.point.interpolation, Interpolation::Ptp)) return {tolerance / 100.0, 1.0};
  const double metres = mmToM(tolerance);
  const bool next_is_ptp = is(next.point.interpolation, Interpolation::Ptp);
  const double share_of_next =
      next_is_ptp ? shareWithin(next, before.moved_frame, metres, scene.arm) : shareOfWay(next, metres);
  return {shareOfWay(before, metres), share_of_next, metres};
}

}  // namespace

Duration overlapBetween(const PlannedPoint& before, const PlannedPoint& next, const PathScene& scene) {
  if (!is(before.point.termination_type, Termination::Blend) || before.point.command_tolerance <= 0.0) {
    return Duration::zero();
  }
  if (before.motion->duration() == Duration::zero() || next.motion->duration() == Duration::zero()) {
    return Duration::zero();
  }
  return motion::overlapAt(scene.arm, {*before.motion, *next.motion, before.moved_frame},
                           blendOf(before, next, scene),
                           {Duration::max(), kCornerStep, motion::kLeastSegment});
}

Duration shorterOverlap(Duration overlap) {
  const Duration half = overlap / 2 - overlap / 2 % kCornerStep;
  return half < motion::kLeastSegment ? Duration::zero() : half;
}

}  // namespace cobot_command::path
