// Where a robot is in its program, event by event, as it and the supervisor agree on it (cell.md, M29).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/supervision/report.h"

namespace cobot_command::cell {

class ProgramWalk {
 public:
  /// `model` has to live longer.
  ProgramWalk(const CellModel& model, RobotIndex robot);

  [[nodiscard]] const CellPlace& place() const { return model_.places[robot_][place_]; }
  /// Precondition: it is at a station that this path leads from.
  [[nodiscard]] automata::EventIndex goOf(PathIndex path) const;
  /// The one event that is next. Precondition: it is on a path.
  [[nodiscard]] automata::EventIndex next() const;
  [[nodiscard]] const CellEvent& meaning(automata::EventIndex event) const { return model_.events[event]; }

  // --- What it tells.
  /// Precondition, here and below: it waits for nothing; the event is possible where it is.
  void want(automata::EventIndex event);
  void happened(automata::EventIndex event);
  /// What it wants, or what was granted last and nothing was done with. Nothing, when there is no such.
  void withdraw();
  [[nodiscard]] bool waits() const { return wanted_.has_value(); }
  /// Was granted last, and can be taken back.
  [[nodiscard]] std::optional<automata::EventIndex> unused() const {
    return granted_ ? std::optional(granted_->event) : std::nullopt;
  }
  /// What was granted cannot be taken back any more.
  void use() { granted_.reset(); }
  [[nodiscard]] const std::vector<NumberedEvent>& untold() const { return events_; }

  // --- What it hears.
  void acknowledge(std::uint64_t number);
  /// It goes on from that place. False: there is none of that name.
  bool restart(const std::string& place, std::uint64_t number);

 private:
  struct Granted {
    automata::EventIndex event = 0;
    automata::StateIndex before = 0;
  };

  [[nodiscard]] automata::StateIndex behind(automata::EventIndex event) const;
  void tell(NumberedEvent::Kind kind, automata::EventIndex event);

  const CellModel& model_;
  RobotIndex robot_;
  automata::StateIndex place_;
  std::uint64_t number_ = 0;
  std::vector<NumberedEvent> events_;  ///< that are not acknowledged yet
  std::optional<NumberedEvent> wanted_;
  std::optional<Granted> granted_;
};

}  // namespace cobot_command::cell
