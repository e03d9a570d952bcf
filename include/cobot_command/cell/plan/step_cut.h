// A step as two on the same path: so that a robot may stand on its way, and is sent on from there (cell.md,
// M14).
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// Farther from the path of the whole, a cut is not made: the TCP [m], and its turn [rad].
inline constexpr double kMostDeviation = 1e-6;
inline constexpr double kMostTurn = 1e-6;

/// How two halves are made, against the whole; as the controller reads their lines.
struct CutMeasure {
  double deviation = 0.0;  ///< of the TCP from where the whole has it, each half by itself, at most [m]
  double turn = 0.0;       ///< the same of its orientation [rad]
  /// The same while both halves add up, when the second one is sent in time [m]. No part of `deviation`:
  /// corners are claimed for themselves, and nobody knows how the controller rounds them (doc/motion.md).
  double corner = 0.0;
  /// By what both take longer then, from rest to rest; below zero where they are faster.
  Duration longer{};
};

struct StepCut {
  Step before;            ///< to the place of the cut, there it blends by 100 %
  Step behind;            ///< on from there, with all that follows the step
  double progress = 0.0;  ///< of the way of the whole, 0..1
  CutMeasure measure;
};

/// Cuts a step at `time` of its motion, since that began. PTPs become two to joints; lines and arcs, two of
/// their kind; relative ones, absolute ones. Nothing where both halves do not keep the path: scripts, both
/// ends of the motion, arcs too short to be known by three points, and whatever measures more than allowed.
///
/// `motion`: as `step` was planned by planCell(), with `speed_override` of its cell.
[[nodiscard]] std::optional<StepCut> cutStep(const arm::ArmModel& arm, const Step& step,
                                             const PlannedMotion& motion, double speed_override,
                                             Duration time);

}  // namespace cobot_command::cell
