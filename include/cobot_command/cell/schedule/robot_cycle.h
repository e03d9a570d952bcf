// What is to be scheduled: of each robot one way from home to home, with the times between its events
// (cell.md, M36).
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
  /// Since the robot's event before it, or since the start. A report comes exactly then; what is controllable
  /// comes then at the earliest.
  Duration after{};
};

/// Where a program branches, the events say which way is taken.
struct RobotCycle {
  std::size_t robot = 0;  ///< its plant, into Problem::automata
  std::vector<TimedEvent> events;
};

/// Each a sentence: what is no robot or not its own event, what its plant cannot do there, times out of
/// range, a cycle that does not end at home, a report that takes from others what they may. None: can be
/// scheduled.
///
/// What plants do that is in no cycle is taken not to happen. Precondition: automata::faultsOf(problem) is
/// empty.
[[nodiscard]] std::vector<std::string> faultsOfCycles(const automata::Problem& problem,
                                                      const std::vector<RobotCycle>& cycles);

/// The one way of a plant without branches, its first event at once: gaps[k] is the time between its events k
/// and k + 1 [s]. A fault is a sentence.
[[nodiscard]] Result<RobotCycle, std::string> cycleWithGaps(const automata::Problem& problem,
                                                            std::size_t robot,
                                                            const std::vector<double>& gaps);

}  // namespace cobot_command::cell
