// The shortest cycle of all robots of an artifact, and the resulting turns on the zones.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/cell/schedule/schedule.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Precondition, here and below: the model is that of the artifact's program. A fault is a sentence.
[[nodiscard]] Result<std::vector<RobotCycle>, std::string> cyclesOf(const Artifact& artifact,
                                                                    const CellModel& model);
/// A fault is a sentence, also if no schedule was found within the limits.
[[nodiscard]] Result<FoundSchedule, std::string> scheduleOf(const Artifact& artifact, const CellModel& model,
                                                            const std::vector<RobotCycle>& cycles,
                                                            const ScheduleLimits& limits);
/// The turns of the shortest cycle found. By zone: the robots that book it in one cycle of all robots, in
/// order; empty if only one robot books it.
[[nodiscard]] Result<std::vector<std::vector<RobotIndex>>, std::string> turnsOf(const Artifact& artifact,
                                                                                const CellModel& model,
                                                                                const ScheduleLimits& limits);

}  // namespace cobot_command::cell
