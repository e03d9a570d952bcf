// How far a motion is on its path: real time runs on, path time can slow down, stand and go on.
//
// The rate of the path time changes linearly between 1 (moving as planned) and 0 (standing), so that position
// and velocity of the arm are continuous. All of that times a pace, which changes in a step: only the
// position is continuous there. Evaluated in closed form: the same instant gives the same answer, however
// often it is asked.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command::simulator {

class PathClock {
 public:
  /// `ramp`: time from rate 1 to 0, or back. Zero: at once.
  explicit PathClock(Duration ramp) : ramp_(ramp) {}

  /// Path time 0 at `now`, at rate 1 and pace 1: a motion starts at rest anyway.
  void start(Instant now);
  /// From `now` on all runs so many times as fast, above 0; ramps take as long as before.
  void setPace(Instant now, double pace);
  /// From `now` on the rate goes to 0.
  void slowDown(Instant now) { steer(now, 0.0); }
  /// From `now` on the rate goes to 1.
  void speedUp(Instant now) { steer(now, 1.0); }

  [[nodiscard]] Duration pathTime(Instant at) const;
  [[nodiscard]] double rate(Instant at) const;
  /// When the path time comes to `path_time`, rounded up; nothing when the clock stands before.
  [[nodiscard]] std::optional<Instant> reaches(Duration path_time) const;
  /// When the rate is what it was steered to.
  [[nodiscard]] Instant settled() const { return since_ + ramp_length_; }

 private:
  /// The latest steering is now: what is behind it does not change any more.
  void rebase(Instant now);
  void steer(Instant now, double target);
  [[nodiscard]] double share(Instant at) const;  // of the pace
  [[nodiscard]] Duration sinceSteering(Instant at) const;
  [[nodiscard]] double slope() const;
  [[nodiscard]] Duration rampDistance() const;

  Duration ramp_;
  Instant since_{};          // the latest steering,
  Duration path_since_{};    // the path time then,
  double rate_since_ = 0.0;  // and the rate, as a share of the pace
  double target_ = 0.0;
  double pace_ = 1.0;
  Duration ramp_length_{};
};

}  // namespace cobot_command::simulator
