// Enforces the order of a schedule at run time, as an additional restriction (doc/cell.md).
//
// It only refuses; grants are still decided by the supervisor. Pure; its owner reports the events to it. A
// maximally permissive supervisor never permanently refuses the event that this order waits for, because in
// this order the robots can reach home from each of its states. A safe order may refuse it permanently, so a
// schedule is used only with a supervisor.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {

class ScheduleOrder {
 public:
  /// Repeats the bookings of the schedule on each zone, from the first one. The turn of an uncontrollable
  /// booking is used when the event that it follows is granted.
  explicit ScheduleOrder(const std::vector<ZoneOrder>& zones);

  /// True if it is the event's turn on each zone that it books, or if it books nothing.
  [[nodiscard]] bool allows(automata::EventIndex event) const;
  /// The robot whose turn it is instead, on the first zone where it is the turn of another robot.
  [[nodiscard]] std::optional<std::size_t> awaits(automata::EventIndex event) const;

  /// The event was granted. No effect while the order is off.
  void granted(automata::EventIndex event);
  /// The event was granted, was not used, and was taken back.
  void withdrawn(automata::EventIndex event);

  /// After a fault: allows everything until all robots are at home.
  void switchOff();
  /// All robots are at home: the order starts again if it was off.
  void allHome();
  [[nodiscard]] bool isOn() const { return is_on_; }

 private:
  struct Turn {
    std::size_t robot = 0;
    automata::EventIndex event = 0;
  };
  struct Zone {
    std::vector<Turn> turns;
    std::size_t next = 0;
  };

  [[nodiscard]] static bool hasTurn(const Zone& zone, automata::EventIndex event);

  std::vector<Zone> zones_;
  bool is_on_ = true;
};

}  // namespace cobot_command::cell
