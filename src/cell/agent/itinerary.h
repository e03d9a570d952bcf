// Which path of its program a robot takes next, and when it has done what was asked for.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/programs/program_guide.h"
#include "cobot_command/cell/model/cell_program.h"

namespace cobot_command::cell {

class Itinerary {
 public:
  explicit Itinerary(const RobotProgram& program) : program_(&program) {}

  /// Why its paths cannot be gone one behind the other.
  [[nodiscard]] static std::optional<std::string> objectionTo(const RobotProgram& program,
                                                              const blocks::ProgramRequest& request);

  /// `under_way`: on this path already, which counts as the first. Precondition: no objection. Why it cannot
  /// begin there; nothing: it has.
  [[nodiscard]] std::optional<std::string> begin(const blocks::ProgramRequest& request, std::size_t station,
                                                 std::optional<PathIndex> under_way);
  /// From this station. Precondition: it is not over.
  [[nodiscard]] PathIndex next(std::size_t station) const;
  /// That one has to wait: where another one leads from the station, that is tried.
  void tryAnother() { ++tried_; }
  [[nodiscard]] bool hasOthers(std::size_t station) const;
  void setOut();
  void reached(std::size_t station);
  /// No other cycle is begun.
  void finish();

  [[nodiscard]] bool isOver() const { return is_over_; }
  [[nodiscard]] int cyclesDone() const { return cycles_done_; }

 private:
  [[nodiscard]] std::vector<PathIndex> pathsFrom(std::size_t station) const;

  const RobotProgram* program_;
  std::vector<PathIndex> paths_;  ///< empty: the whole program
  std::size_t next_ = 0;          ///< of these, as often as they come round
  int cycles_ = 1;
  int cycles_done_ = 0;
  std::size_t tried_ = 0;
  bool is_between_ = true;  ///< two cycles
  bool is_over_ = true;
};

}  // namespace cobot_command::cell
