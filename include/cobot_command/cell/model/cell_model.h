// A cell as automata: a plant for each robot, a spec for each zone, and the meaning of each event
// (doc/cell.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/verification.h"
#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// An event of a robot. Its index is that of the event in the problem, and is used in messages. The name is
/// never parsed.
struct CellEvent {
  enum class Kind {
    Go,       ///< it starts a path
    Book,     ///< it gets zones
    Release,  ///< it returns zones
    Reached   ///< it is at the station at the end of the path
  };
  Kind kind = Kind::Go;
  RobotIndex robot = 0;
  PathIndex path = 0;
  std::vector<ZoneIndex> zones;
};

/// Place of a robot in its program: at a station, or after a number of events of a path.
struct CellPlace {
  std::optional<std::size_t> station;
  PathIndex path = 0;            ///< if it is not at a station
  std::size_t behind = 0;        ///< number of completed zone steps of the path
  std::vector<ZoneIndex> holds;  ///< ascending
  std::string name;              ///< "T1", or "HOME>T1 +2"
};

struct CellModel {
  CellProgram program;
  /// Robots first, in their order, then zones.
  automata::Problem problem;
  std::vector<CellEvent> events;               ///< by event of the problem
  std::vector<std::vector<CellPlace>> places;  ///< [robot][local state of its plant]

  [[nodiscard]] std::size_t robots() const { return program.robots.size(); }
  /// Index of the automaton of a zone in the problem, and in tuples.
  [[nodiscard]] std::size_t automatonOf(ZoneIndex zone) const { return robots() + zone; }
  /// The owner of a zone in a local state of its automaton; std::nullopt: free.
  [[nodiscard]] std::optional<RobotIndex> holder(ZoneIndex zone, automata::StateIndex state) const;
  [[nodiscard]] automata::Holds holds() const;

  std::vector<std::vector<std::optional<RobotIndex>>> holders;  ///< [zone][local state]
};

/// Faults, one sentence each: a zone that is booked while it is held, or released while it is not; a station
/// at which paths disagree about the held zones; a robot that cannot reach home, or cannot leave it.
[[nodiscard]] Result<CellModel, std::vector<std::string>> modelOf(const CellProgram& program);

}  // namespace cobot_command::cell
