// Divides a step into two on the same path, so that a robot can stop in between and be sent on from there
// (doc/cell.md).
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// Largest deviation of a cut from the path of the whole motion: of the TCP [m], and of its orientation
/// [rad]. A cut that deviates more is not made.
inline constexpr double kMostDeviation = 1e-6;
inline constexpr double kMostTurn = 1e-6;

/// Comparison of the two halves with the whole motion, as the controller reads their lines.
struct CutMeasure {
  double deviation = 0.0;  ///< largest deviation of the TCP from the whole motion, each half alone [m]
  double turn = 0.0;       ///< the same for its orientation [rad]
  /// The same while both halves overlap, if the second one is sent in time [m]. Not part of `deviation`:
  /// corners are claimed separately, and it is unknown how the controller rounds them (doc/motion.md).
  double corner = 0.0;
  /// Additional time of both halves in that case, from rest to rest; negative if they are faster.
  Duration longer{};
};

struct StepCut {
  Step before;            ///< to the cut, where it blends by 100 %
  Step behind;            ///< from the cut, with everything that follows the step
  double progress = 0.0;  ///< share of the path of the whole motion, 0..1
  CutMeasure measure;
};

/// Cuts a step at `time` since the start of its motion. A PTP becomes two PTPs to joints, a line two lines,
/// an arc two arcs; relative motions become absolute ones. std::nullopt if both halves would not keep the
/// path: scripts, a cut at either end of the motion, arcs too short to be defined by three points, and
/// deviations above the limits.
///
/// `motion`: `step` as planned by planCell(), with `speed_override` of its cell.
[[nodiscard]] std::optional<StepCut> cutStep(const arm::ArmModel& arm, const Step& step,
                                             const PlannedMotion& motion, double speed_override,
                                             Duration time);

}  // namespace cobot_command::cell
