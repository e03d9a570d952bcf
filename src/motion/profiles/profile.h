// How far a motion is at every time, whatever its way: the progress grows from 0 to 1.
#pragma once

#include <memory>

#include "cobot_command/common/time.h"

namespace cobot_command::motion {

/// Immutable.
class Profile {
 public:
  virtual ~Profile() = default;

  /// [s]
  [[nodiscard]] virtual double duration() const = 0;
  /// The same, rounded up to whole nanoseconds: a motion is really over then.
  [[nodiscard]] virtual Duration time() const { return fromSeconds(duration()); }
  /// How long it would take at top speed all the way [s].
  [[nodiscard]] virtual double travel() const = 0;
  /// To its highest speed, and from there to rest [s].
  [[nodiscard]] virtual double timeUp() const = 0;
  [[nodiscard]] virtual double timeDown() const = 0;
  [[nodiscard]] virtual bool startsAtRest() const = 0;

  /// Precondition of all below: 0 <= time <= duration() [s], and the duration is not zero.
  [[nodiscard]] virtual double progress(double time) const = 0;
  /// [1/s]
  [[nodiscard]] virtual double rate(double time) const = 0;
  /// What share of its top speed would do where a joint is `excess` (> 1) times too fast at `time`.
  [[nodiscard]] virtual double usableShare(double time, double excess) const = 0;

  /// The speed as a share (0..1) of the top speed.
  [[nodiscard]] double shareOfTopSpeed(double time) const { return rate(time) * travel(); }
};

using ProfilePtr = std::shared_ptr<const Profile>;

}  // namespace cobot_command::motion
