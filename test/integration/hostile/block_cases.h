// A good goal of each function block, and whether what it promises has come true in the simulated robot.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::hostile {

struct BlockCase {
  blocks::Block block;
  blocks::Goal goal;
  /// Done only when the queue tag of a motion has come back.
  bool awaits_tag = false;
  /// What of a Done goal's promise is not so; empty: all is as promised.
  std::function<std::string(const simulator::RobotState&)> lie;
};

enum class Pace {
  Quick,    ///< motions of some 0.1 s of real time
  Lasting,  ///< of more than a second, so that something can happen meanwhile
};

/// One for each block but connect. The robot stands at the posture of its start; for the stop block it is to
/// be moved by somebody first.
[[nodiscard]] std::vector<BlockCase> blockCases(Pace pace);

/// A motion that shows that the layer works, to where no case goes.
[[nodiscard]] BlockCase proofOfWork();

}  // namespace cobot_command::hostile
