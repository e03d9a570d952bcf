// The two ways to have a controller jog: by velocities, and by short moves that it always has a few of.
//
// Both are asked what to send, and are told when that went out and what the arm does. Neither knows why it
// goes on or ends: that is the run's (jog_run.h).
#pragma once

#include <memory>
#include <optional>

#include "jog/jog_plan.h"

#include "cobot_command/blocks/jog.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

enum class JogWish {
  Drive,
  Rest,  ///< it may have to go on
  Leave  ///< for good
};

struct JogOrder {
  Order order;
  bool awaits_end =
      false;  ///< it is at the controller until that has done with it; else until it is accepted
};

class JogDrive {
 public:
  virtual ~JogDrive() = default;

  [[nodiscard]] virtual JogMeans means() const = 0;
  /// So long behind a keep-alive it goes on.
  [[nodiscard]] virtual Duration patience() const = 0;
  /// Before next(), with every event. `kept`: the last keep-alive.
  virtual void look(Instant now, Instant kept) = 0;
  [[nodiscard]] virtual std::optional<JogOrder> next(JogWish wish) const = 0;
  /// What next() said goes out; and went out.
  virtual void started(JogWish wish) = 0;
  virtual void sent(Instant now) = 0;
  /// A status frame shows the arm there.
  virtual void see(double drive, Instant now) = 0;
  /// It must not drive further.
  [[nodiscard]] virtual bool isAtEnd(Instant now) const = 0;
  /// So long behind a wish for rest the arm stands; nothing: what is at the controller knows its own time.
  [[nodiscard]] virtual std::optional<Duration> timeToRest() const = 0;
  [[nodiscard]] virtual std::optional<Instant> nextDeadline(JogWish wish) const = 0;
};

/// A controller may want to see as much room in front of an arm whose velocity it sets: for a ramp to that,
/// and one to rest.
[[nodiscard]] bool hasRoomForVelocity(const JogPlan& plan, double driven);

/// ContinueVJog or ContinueVLine: the controller keeps a velocity until it is told otherwise.
[[nodiscard]] std::unique_ptr<JogDrive> velocityDrive(std::shared_ptr<const JogPlan> plan);

/// The arm comes to rest behind the last move by itself, so nobody has to stop it. An increment is one move.
[[nodiscard]] std::unique_ptr<JogDrive> movesDrive(std::shared_ptr<const JogPlan> plan);

}  // namespace cobot_command::blocks
