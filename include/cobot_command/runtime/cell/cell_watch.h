// The input of a cell's monitor, created from the cell's file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

/// The robots of a cell at their places, with their tools. Each part that a step of their program attaches is
/// one that they may carry. An error is a sentence: a shape that cannot be made of capsules.
[[nodiscard]] Result<std::vector<cell::WatchedRobot>, std::string> watchedRobots(const cell::Cell& cell);

/// The monitor of a cell's robots, mechanisms and obstacles, with the margin of the cell. `stop_distance`
/// [m]; nullopt: half of the margin. An error is a sentence: a shape that cannot be made of capsules, or a
/// stop distance that is not within the margin.
[[nodiscard]] Result<cell::Monitor, std::string> monitorOf(const cell::Cell& cell,
                                                           cell::MonitorSettings::Mode mode,
                                                           std::optional<double> stop_distance);

}  // namespace cobot_command::runtime
