// A schedule as a picture of characters, for people.
#pragma once

#include <cstddef>
#include <string>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {

/// A line for each robot and each zone, `columns` characters of time wide; at least 10 are taken. What is
/// shorter than a column may not be seen. Precondition: the schedule is of that problem.
[[nodiscard]] std::string ganttOf(const Schedule& schedule, const automata::Problem& problem,
                                  std::size_t columns = 72);

}  // namespace cobot_command::cell
