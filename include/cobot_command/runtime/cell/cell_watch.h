// What the monitor of a cell watches, made of the cell's file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

/// The robots of a cell where they stand, with their tools, and with each part that a step of their program
/// attaches as one that they may carry. A fault is a sentence: a shape that cannot be made of capsules.
[[nodiscard]] Result<std::vector<cell::WatchedRobot>, std::string> watchedRobots(const cell::Cell& cell);

/// Robots, mechanisms and obstacles of a cell under watch, by its margin. `stop_distance` [m]; nothing: half
/// of the margin. A fault is a sentence: a shape that cannot be made of capsules, or a stop distance that is
/// no part of the margin.
[[nodiscard]] Result<cell::Monitor, std::string> monitorOf(const cell::Cell& cell,
                                                           cell::MonitorSettings::Mode mode,
                                                           std::optional<double> stop_distance);

}  // namespace cobot_command::runtime
