// A motion from rest to rest whose ramps follow a law: its own rates, on a grid of whole milliseconds.
#pragma once

#include <cmath>

#include "profiles/profile.h"
#include "profiles/ramp.h"

namespace cobot_command::motion {

/// How long a motion speeds up, keeps its speed and slows down [s].
struct Phases {
  double up = 0.0;
  double cruise = 0.0;
  double down = 0.0;

  [[nodiscard]] double duration() const { return up + cruise + down; }
};

/// The shortest ramp on the grid [s]. A shorter cruise is none: the speed is lowered until it is so long, as
/// a segment of a PVT across both its ends would be faster than the motion is anywhere.
inline constexpr double kShortestPhase = toSeconds(kLeastSegment);

/// In closed form. `way` > 0 in the unit of the rates. Where it is too short for the top speed, the
/// accelerations stay and the speed is lower.
[[nodiscard]] Phases phasesOf(double way, const Rates& rates, const RampShape& shape);

/// Each phase a whole number of milliseconds, none shorter than it was, ramps at least kShortestPhase: what
/// is planned is then what can be sent.
[[nodiscard]] Phases onGrid(const Phases& phases);

class RampedProfile final : public Profile {
 public:
  /// Precondition: on the grid; or nothing, for a motion without a way.
  RampedProfile(const Phases& phases, const RampShape& shape)
      : phases_(phases), up_(shape.law, shape.up), down_(shape.law, shape.down) {}

  [[nodiscard]] double duration() const override { return phases_.duration(); }
  [[nodiscard]] Duration time() const override {
    return std::chrono::milliseconds(std::llround(1e3 * duration()));
  }
  [[nodiscard]] double travel() const override { return phases_.cruise + 0.5 * (phases_.up + phases_.down); }
  [[nodiscard]] double timeUp() const override { return phases_.up; }
  [[nodiscard]] double timeDown() const override { return phases_.down; }
  /// The highest acceleration, and deceleration, of the progress [1/s^2].
  [[nodiscard]] double steepestUp() const { return up_.stretch() / (phases_.up * travel()); }
  [[nodiscard]] double steepestDown() const { return down_.stretch() / (phases_.down * travel()); }
  [[nodiscard]] bool startsAtRest() const override { return true; }
  [[nodiscard]] double progress(double time) const override;
  [[nodiscard]] double rate(double time) const override;
  /// The accelerations stay, so that only what is above the top speed is cut off.
  [[nodiscard]] double usableShare(double time, double excess) const override {
    return shareOfTopSpeed(time) / excess;
  }

 private:
  Phases phases_;
  Ramp up_;
  Ramp down_;
};

}  // namespace cobot_command::motion
