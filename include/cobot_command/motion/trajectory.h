// A motion that was planned wholly and can be made: where every joint is at every time.
//
// Immutable; safe to share between threads.
#pragma once

#include <memory>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

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

  /// How long it slows down before its end; as planned from rest it speeds up as long.
  [[nodiscard]] virtual Duration rampTime() const = 0;

  [[nodiscard]] JointState end() const { return at(duration()); }
};

using TrajectoryPtr = std::shared_ptr<const Trajectory>;

}  // namespace cobot_command::motion
