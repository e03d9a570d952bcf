// Keeps the first motion back until those come that it may blend into, or some time has passed (SRCI:
// DelayTime, WaitForNrOfCmd).
#pragma once

#include <optional>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

/// Single moves are one, a path has its points, what does not move counts for nothing.
[[nodiscard]] int motionsOf(const blocks::Goal& goal);

class MotionHold {
 public:
  /// So long at most, and until so many motions are there; 0 motions: their number does not count. No delay:
  /// nothing is held.
  void use(Duration delay, int motions) {
    delay_ = delay;
    motions_ = motions;
  }
  /// Nothing is held any more.
  void end();

  /// A motion that nothing is in front of, with a robot that stands.
  void begin(blocks::GoalId first, Instant now);
  /// Whether what waits has to go on waiting. `first`: the first of it; `motions`: how many there are.
  [[nodiscard]] bool holdsBack(blocks::GoalId first, int motions);
  [[nodiscard]] bool isHolding() const { return first_.has_value(); }

  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  Duration delay_{};
  int motions_ = 0;
  std::optional<blocks::GoalId> first_;
  Instant until_{};
};

}  // namespace cobot_command::command
