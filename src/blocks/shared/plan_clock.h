// The time of a plan that the controller carries out: at the rate of its project speed, and standing still
// while the robot is held.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class PlanClock {
 public:
  /// It begins now. `rate`: so much faster than planned the controller's time runs, above 0.
  PlanClock(double rate, Instant now) : rate_(rate), began_(now) {}

  void hold(Instant now);
  /// False: it was not held.
  bool letGo(Instant now);
  [[nodiscard]] bool isHeld() const { return held_since_.has_value(); }
  /// So much of the plan is over by now.
  void setTime(Duration planned, Instant now) { began_ = now - byController(planned); }
  void advance(Duration planned) { began_ -= byController(planned); }

  /// Of the plan, since it began.
  [[nodiscard]] Duration time(Instant now) const;
  /// How long the controller takes for so much of the plan.
  [[nodiscard]] Duration byController(Duration planned) const;

 private:
  double rate_;
  Instant began_;  ///< later by every hold since
  std::optional<Instant> held_since_;
};

}  // namespace cobot_command::blocks
