// Motions and the interface of SRCI: what its reactions do to the robot and to what waits.
#pragma once

#include <optional>
#include <string>

#include "arbiter/core_parts.h"
#include "arbiter/turns.h"
#include "paths/pause_desk.h"

namespace cobot_command::command {

class Interruption {
 public:
  /// All have to live longer.
  Interruption(const CoreParts& parts, const ArbiterDesks& desks, Turns& turns, PauseDesk& pause)
      : parts_(parts), desks_(desks), turns_(turns), pause_(pause) {}

  /// Behind each event, before anything begins.
  void look(Instant now);
  /// A stop has taken what there was.
  void stopConfirmed() { is_stopped_ = true; }
  /// Once, at the end of an event.
  void proceed();

 private:
  /// Something of this layer may move the robot, as far as nothing holds it.
  [[nodiscard]] bool moves() const;
  /// Whoever needs the interface for moving has disabled it.
  void stopWithout(Instant now);
  void warnOfReaction();

  CoreParts parts_;
  ArbiterDesks desks_;
  Turns& turns_;
  PauseDesk& pause_;
  bool is_stopped_ = false;
  bool held_back_ = false;  ///< what waits, when it was looked at last
};

}  // namespace cobot_command::command
