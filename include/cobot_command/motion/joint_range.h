// Between which angles each joint stays for a while: a promise, which proofs rest on.
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
  /// `tolerance`: so far outside each joint may be [rad, not negative].
  [[nodiscard]] bool contains(const arm::JointVector& joints, double tolerance = 0.0) const {
    return (joints.array() >= lower.array() - tolerance).all() &&
           (joints.array() <= upper.array() + tolerance).all();
  }
  /// Contains them, too, from then on.
  void include(const arm::JointVector& joints) { include(of(joints)); }
  void include(const JointRange& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
};

/// So much a range is wider than what was proved, on either side [rad]. Sums and products of joints are off
/// by some 1e-15 rad; of what an inverse makes of rounding, paths take care themselves. 1e-9 rad move no part
/// of an arm by more than a few nanometres.
inline constexpr double kRangeRoom = 1e-9;

/// Why there is no range: UNBOUNDED. Nothing can be proved of the joints between two moments of a motion.
struct Unbounded {
  Duration from{};      ///< since the motion began
  Duration to{};        ///< likewise
  std::string message;  ///< "UNBOUNDED: ...": where, why, what to do
};

/// With its message; `why` and what to do: "the path is too close to a singularity: choose another path".
[[nodiscard]] Unbounded unbounded(Duration from, Duration to, const char* why);

}  // namespace cobot_command::motion
