// A cell as automata: a plant for each robot, a spec for each zone, and what each event means (cell.md, M18
// and M19).
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

/// What happens to a robot. Its index is that of the event in the problem, and what messages carry; nothing
/// is ever read out of the name.
struct CellEvent {
  enum class Kind {
    Go,       ///< it sets out on a path
    Book,     ///< zones become its own
    Release,  ///< and are no longer
    Reached   ///< it stands at the station that the path leads to
  };
  Kind kind = Kind::Go;
  RobotIndex robot = 0;
  PathIndex path = 0;
  std::vector<ZoneIndex> zones;
};

/// Where a robot is in its program: at a station, or behind so many events of a path.
struct CellPlace {
  std::optional<std::size_t> station;
  PathIndex path = 0;            ///< where it is at no station
  std::size_t behind = 0;        ///< zone steps of the path that are done
  std::vector<ZoneIndex> holds;  ///< ascending
  std::string name;              ///< "T1", or "HOME>T1 +2"
};

struct CellModel {
  CellProgram program;
  /// Robots first, in their order, then zones.
  automata::Problem problem;
  std::vector<CellEvent> events;               ///< by event of the problem
  std::vector<std::vector<CellPlace>> places;  ///< by robot, and by local state of its plant

  [[nodiscard]] std::size_t robots() const { return program.robots.size(); }
  /// Where the automaton of a zone is in the problem, and in tuples.
  [[nodiscard]] std::size_t automatonOf(ZoneIndex zone) const { return robots() + zone; }
  /// By local state of the automaton of a zone: who holds it; nobody: it is free.
  [[nodiscard]] std::optional<RobotIndex> holder(ZoneIndex zone, automata::StateIndex state) const;
  [[nodiscard]] automata::Holds holds() const;

  std::vector<std::vector<std::optional<RobotIndex>>> holders;  ///< by zone and local state
};

/// Faults, each a sentence: a zone that is booked while it is held, or released while it is not; a station at
/// which paths disagree about what is held; a robot that cannot come home, or nowhere from home.
[[nodiscard]] Result<CellModel, std::vector<std::string>> modelOf(const CellProgram& program);

}  // namespace cobot_command::cell
