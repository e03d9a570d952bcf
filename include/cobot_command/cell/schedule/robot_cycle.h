// Input of the scheduling: one path from home to home per robot, with the times between its events
// (doc/cell.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

struct TimedEvent {
  automata::EventIndex event = 0;
  /// Since the previous event of the robot, or since the start. An uncontrollable event happens exactly then;
  /// a controllable event happens then at the earliest.
  Duration after{};
};

/// If a program branches, the events determine the branch.
struct RobotCycle {
  std::size_t robot = 0;  ///< its plant, index into Problem::automata
  std::vector<TimedEvent> events;
};

/// One sentence each: not a robot, or an event of another one; an event that its plant does not have there;
/// times out of range; a cycle that does not end at home; an uncontrollable event that restricts other
/// robots. Empty: it can be scheduled.
///
/// Events of plants that are in no cycle are assumed not to happen. Precondition: automata::faultsOf(problem)
/// is empty.
[[nodiscard]] std::vector<std::string> faultsOfCycles(const automata::Problem& problem,
                                                      const std::vector<RobotCycle>& cycles);

/// The only path of a plant without branches, its first event immediately: gaps[k] is the time between its
/// events k and k + 1 [s]. A fault is a sentence.
[[nodiscard]] Result<RobotCycle, std::string> cycleWithGaps(const automata::Problem& problem,
                                                            std::size_t robot,
                                                            const std::vector<double>& gaps);

}  // namespace cobot_command::cell
