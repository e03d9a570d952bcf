// One cycle of a robot from home to home, as it goes when nothing waits.
#pragma once

#include <string>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Along the first path that is listed at each station. Else a robot that is always granted the first one
/// never ends a cycle.
[[nodiscard]] bool comesHome(const RobotProgram& program);

/// Along the first path that is listed at each station. Precondition: the model is that of the artifact's
/// program.
[[nodiscard]] Result<RobotCycle, std::string> cycleOf(const Artifact& artifact, const CellModel& model,
                                                      RobotIndex robot);

}  // namespace cobot_command::cell
