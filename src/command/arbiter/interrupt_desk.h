// Clients that interrupt what is under way, and let it go on (states: interrupt_states.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arbiter/core_parts.h"
#include "arbiter/interrupt_states.h"
#include "arbiter/turns.h"
#include "sending/set_aside.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/command/interruption.h"

namespace cobot_command::command {

class InterruptDesk {
 public:
  /// All have to live longer.
  InterruptDesk(const CoreParts& parts, const ArbiterDesks& desks, Turns& turns)
      : parts_(parts), desks_(desks), turns_(turns) {}

  /// Stops what is under way, and keeps it with all that waits. `reply`: when the robot stands.
  void interrupt(const InterruptReply& reply, Instant now);
  /// What was interrupted goes on, if the robot is where it was.
  void goOn(const InterruptReply& reply, Instant now);
  /// A way back, with where that ends; nothing: it is another goal, or nothing is interrupted.
  [[nodiscard]] std::optional<blocks::Goal> withPlace(const blocks::Goal& goal) const;
  /// Behind each event, before anything begins.
  void look(Instant now);

 private:
  using State = InterruptState;
  using Event = InterruptEvent;

  void fire(Event event, Instant now);
  void setAside(Instant now);
  void putBack(Instant now);
  [[nodiscard]] InterruptAnswer objectionToInterrupting() const;
  /// Why what is under way could not go on later; nothing: it can.
  [[nodiscard]] std::optional<std::string> whyNotLater() const;
  [[nodiscard]] InterruptAnswer objectionToGoingOn() const;
  /// How far the robot is from there [deg], and which joint that is.
  [[nodiscard]] std::string awayText(const arm::JointVector& place) const;
  [[nodiscard]] Setup setup() const;
  [[nodiscard]] std::string goesOnText() const;
  [[nodiscard]] bool isAt(const arm::JointVector& place) const;
  void answer(const InterruptAnswer& answer);

  CoreParts parts_;
  ArbiterDesks desks_;
  Turns& turns_;
  State state_ = State::None;
  std::vector<InterruptReply> waiting_;
};

}  // namespace cobot_command::command
