// One cycle of a robot from home to home, as it goes when nothing waits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// The first path that is listed at each station, from home on. Nothing: that does not lead back home, so
/// that a robot that is always granted the first one never ends a cycle.
[[nodiscard]] std::optional<std::vector<PathIndex>> wayHome(const RobotProgram& program);

/// Along that way. Precondition: the model is that of the artifact's program.
[[nodiscard]] Result<RobotCycle, std::string> cycleOf(const Artifact& artifact, const CellModel& model,
                                                      RobotIndex robot);

}  // namespace cobot_command::cell
