// Proven bounds of each joint over a time interval.
#pragma once

#include <string>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::motion {

/// A box of postures [rad]; lower <= upper, joint by joint.
struct JointRange {
  arm::JointVector lower;
  arm::JointVector upper;

  [[nodiscard]] static JointRange of(const arm::JointVector& joints) { return {joints, joints}; }

  [[nodiscard]] arm::JointVector centre() const { return 0.5 * (lower + upper); }
  [[nodiscard]] arm::JointVector widths() const { return upper - lower; }
  /// `tolerance`: distance outside the range that is accepted for each joint [rad, not negative].
  [[nodiscard]] bool contains(const arm::JointVector& joints, double tolerance = 0.0) const {
    return (joints.array() >= lower.array() - tolerance).all() &&
           (joints.array() <= upper.array() + tolerance).all();
  }
  /// Extends the range to contain them.
  void include(const arm::JointVector& joints) { include(of(joints)); }
  void include(const JointRange& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
};

/// Margin added to each side of a proven range [rad]. Rounding of sums and products of joints is about 1e-15
/// rad. Paths account for the rounding of the inverse kinematics separately. 1e-9 rad moves no part of an arm
/// by more than a few nanometres.
inline constexpr double kRangeRoom = 1e-9;

/// Why there is no range (UNBOUNDED): nothing can be proven about the joints between two times of a motion.
struct Unbounded {
  Duration from{};      ///< since the start of the motion
  Duration to{};        ///< since the start of the motion
  std::string message;  ///< "UNBOUNDED: ...": where, why, what to do
};

/// Builds the message; `why` is the cause and the remedy: "the path is too close to a singularity: choose
/// another path".
[[nodiscard]] Unbounded unbounded(Duration from, Duration to, const char* why);

}  // namespace cobot_command::motion
