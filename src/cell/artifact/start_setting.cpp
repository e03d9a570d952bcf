#include "cobot_command/cell/artifact/start_setting.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::cell {

arm::Pose startTcp(const Artifact& artifact, RobotIndex robot) {
  const RobotProgram& program = artifact.program.robots[robot];
  for (std::size_t path = 0; path < program.paths.size(); ++path) {
    if (program.paths[path].from != program.home) continue;
    const auto& frames = artifact.robots[robot].paths[path].frames;
    const auto moving = std::find_if(frames.begin(), frames.end(),
                                     [](const ArtifactFrame& frame) { return frame.start.has_value(); });
    if (moving != frames.end()) return moving->tcp;
  }
  return arm::Pose::Identity();
}

int highestProjectSpeed(const Artifact& artifact) {
  // A pendant has steps of 5 %; 0.8 is a little less as a number.
  const int steps = static_cast<int>(std::floor(20.0 * artifact.parameters.speed_override + 1e-9));
  return 5 * std::clamp(steps, 1, 20);
}

}  // namespace cobot_command::cell
