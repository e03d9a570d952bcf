// A completely planned motion: the position of every joint at every time.
//
// Immutable; safe to share between threads.
#pragma once

#include <algorithm>
#include <memory>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/joint_range.h"

namespace cobot_command::motion {

struct JointState {
  arm::JointVector position;  ///< [rad]
  arm::JointVector velocity;  ///< [rad/s]
};

class Trajectory {
 public:
  virtual ~Trajectory() = default;

  /// Zero for a motion that starts where it ends.
  [[nodiscard]] virtual Duration duration() const = 0;

  /// The state at `time` since the start; before it the start, after the duration the end. At rest at the
  /// end, and also at the start unless it is blended. The same time always gives the bit-identical state, in
  /// any order of calls.
  [[nodiscard]] virtual JointState at(Duration time) const = 0;

  /// Duration of the acceleration from rest and of the deceleration before the end.
  [[nodiscard]] virtual Duration timeUp() const = 0;
  [[nodiscard]] virtual Duration timeDown() const = 0;

  /// Completed share of the path, 0..1. Share of the time if the motion has no single profile.
  [[nodiscard]] virtual double progress(Duration time) const {
    return std::clamp(toSeconds(time) / std::max(toSeconds(duration()), 1e-9), 0.0, 1.0);
  }

  /// Path length of the TCP for which it was planned [m]; 0 if the motion was not planned for a TCP.
  [[nodiscard]] virtual double tcpWay() const { return 0.0; }

  [[nodiscard]] JointState end() const { return at(duration()); }

  /// A range that contains every joint at every time between the two times, not only at sampled times. It is
  /// proven for each kind of motion (doc/motion.md). Times are clamped as in at() and may be in either order.
  /// For one instant, or for an arm at rest, it is the posture. Every range includes kRangeRoom. The shorter
  /// the interval, the tighter the range. Refused if nothing can be proven.
  [[nodiscard]] Result<JointRange, Unbounded> jointRange(Duration from, Duration to) const;

 private:
  /// 0 <= from < to <= duration(). A kind of motion that does not implement it is refused.
  [[nodiscard]] virtual Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const;
};

using TrajectoryPtr = std::shared_ptr<const Trajectory>;

}  // namespace cobot_command::motion
