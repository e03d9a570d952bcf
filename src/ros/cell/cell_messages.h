// What robots of a cell and their supervisor tell each other ⇄ messages. Total: what comes from outside and
// cannot be meant becomes something that is refused (cell::malformed()).
#pragma once

#include <cstdint>

#include "cobot_command/CellReport.h"
#include "cobot_command/CellState.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/report.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::CellReport toMessage(const cell::RobotReport& report);
[[nodiscard]] cell::RobotReport toReport(const cobot_command::CellReport& message);

/// `number`: of the states of this epoch.
[[nodiscard]] cobot_command::CellState toMessage(const cell::CellStatus& status, std::uint64_t number);
/// Numbers that stand for nothing become what grants nothing: FAULT, QUARANTINED, HOLDING.
[[nodiscard]] cell::CellStatus toStatus(const cobot_command::CellState& message);

}  // namespace cobot_command::ros_adapter
