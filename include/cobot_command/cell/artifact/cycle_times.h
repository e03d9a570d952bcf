// One cycle of a robot from home to home, without waiting.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Follows the first path listed at each station, from home. std::nullopt: these paths do not lead back home,
/// so a robot that is always granted the first path never ends a cycle.
[[nodiscard]] std::optional<std::vector<PathIndex>> wayHome(const RobotProgram& program);

/// The cycle on these paths. Precondition: the model is that of the artifact's program.
[[nodiscard]] Result<RobotCycle, std::string> cycleOf(const Artifact& artifact, const CellModel& model,
                                                      RobotIndex robot);

}  // namespace cobot_command::cell
