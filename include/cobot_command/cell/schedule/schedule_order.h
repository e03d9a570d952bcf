// The order of a schedule as a further restriction while the cell runs (cell.md, M37).
//
// It only says no: what is granted is still up to the supervisor. Pure; who keeps it tells it what happened.
// A largest supervisor never refuses for good what this order waits for, as the robots can come home in it
// from wherever they are in it; a safe order may, so that a schedule is kept under a supervisor only.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {

class ScheduleOrder {
 public:
  /// On each zone the bookings of the schedule, again and again, from the first one on. A booking that cannot
  /// be refused has its turn when the event is granted that it follows.
  explicit ScheduleOrder(const std::vector<ZoneOrder>& zones);

  /// It is its turn on each zone that it books. True for what books nothing.
  [[nodiscard]] bool allows(automata::EventIndex event) const;
  /// The robot whose turn it is instead, on the first zone where it is another's.
  [[nodiscard]] std::optional<std::size_t> awaits(automata::EventIndex event) const;

  /// It was granted. Of no effect while the order is off.
  void granted(automata::EventIndex event);
  /// It was granted, nothing was done with it, and it was taken back.
  void withdrawn(automata::EventIndex event);

  /// After a fault: allows everything until all are home.
  void switchOff();
  /// All robots are home: the order begins anew, if it was off.
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
