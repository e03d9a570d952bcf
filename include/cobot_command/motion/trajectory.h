// A motion that was planned wholly and can be made: where every joint is at every time.
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
  /// end, and at the start too unless it is blended. The same time always gives the bit-identical state, in
  /// whatever order it is asked.
  [[nodiscard]] virtual JointState at(Duration time) const = 0;

  /// How long it speeds up from rest, and slows down before its end.
  [[nodiscard]] virtual Duration timeUp() const = 0;
  [[nodiscard]] virtual Duration timeDown() const = 0;

  /// How much of its way is done, 0..1; of its time, where it has no one profile.
  [[nodiscard]] virtual double progress(Duration time) const {
    return std::clamp(toSeconds(time) / std::max(toSeconds(duration()), 1e-9), 0.0, 1.0);
  }

  /// Of the TCP that it was planned for [m]; 0 of one that says nothing of a TCP.
  [[nodiscard]] virtual double tcpWay() const { return 0.0; }

  [[nodiscard]] JointState end() const { return at(duration()); }

  /// Contains every joint at every moment between both times, not only at those that somebody asks for: a
  /// proof, each kind of motion has its own (doc/motion.md). Times are clamped as those of at(), in either
  /// order. Of one moment, and of an arm at rest, the posture; all with kRangeRoom. The shorter the time, the
  /// closer it is to what the joints really do. Refused where nothing can be proved.
  [[nodiscard]] Result<JointRange, Unbounded> jointRange(Duration from, Duration to) const;

 private:
  /// 0 <= from < to <= duration(). A kind that does not say how it moves between two moments is refused.
  [[nodiscard]] virtual Result<JointRange, Unbounded> rangeWithin(Duration from, Duration to) const;
};

using TrajectoryPtr = std::shared_ptr<const Trajectory>;

}  // namespace cobot_command::motion
