// A schedule as a text chart.
#pragma once

#include <cstddef>
#include <string>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {

/// One line for each robot and each zone, with `columns` characters for the time, at least 10. Events shorter
/// than a column may be invisible. Precondition: the schedule belongs to that problem.
[[nodiscard]] std::string ganttOf(const Schedule& schedule, const automata::Problem& problem,
                                  std::size_t columns = 72);

}  // namespace cobot_command::cell
