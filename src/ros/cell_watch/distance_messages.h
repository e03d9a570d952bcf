// What the monitor of a cell has found, as messages, sentences and diagnostics.
#pragma once

#include <string>

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "cobot_command/CellDistances.h"
#include "cobot_command/cell/monitor/monitor.h"

namespace cobot_command::ros_adapter {

struct WatchView;

/// Without a stamp.
[[nodiscard]] cobot_command::CellDistances toMessage(const cell::MonitorStatus& status);
/// Of a breach that has ended.
[[nodiscard]] std::string sentenceOf(const cell::Breach& breach);
/// ERROR: all were stopped. WARN: closer than the margin, or a robot or mechanism was not heard, or could not
/// be told to stop.
void describeMonitor(diagnostic_updater::DiagnosticStatusWrapper& status, const WatchView& view,
                     cell::MonitorSettings::Mode mode);

}  // namespace cobot_command::ros_adapter
