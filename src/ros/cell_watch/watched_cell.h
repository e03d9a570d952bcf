// What the monitor of a cell watches, made of the cell's file.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// Robots, mechanisms and obstacles of a cell under watch, by its margin. Each robot has its tool, and each
/// part that a step of its program attaches as one that it may carry. `stop_distance` [m]; nothing: half of
/// the margin. A fault is a sentence: a shape that cannot be made of capsules, or a stop distance that is no
/// part of the margin.
[[nodiscard]] Result<cell::Monitor, std::string> watchedCell(const cell::Cell& cell,
                                                             cell::MonitorSettings::Mode mode,
                                                             std::optional<double> stop_distance);

}  // namespace cobot_command::ros_adapter
