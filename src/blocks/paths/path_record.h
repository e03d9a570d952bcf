// What a run of paths remembers of the way that it has driven.
#pragma once

#include <optional>

#include "chain/path_chain.h"
#include "paths/path_stand.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/path/driven_path.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

class PathRecord {
 public:
  /// The last piece of it.
  void sent(const PathChain& chain);
  /// The robot has come to there; nothing: nobody knows how far.
  void came(const std::optional<PathStand>& stand);
  /// What is left is planned anew from there.
  void stopped(const arm::JointVector& joints) { driven_.cut(joints); }
  void robotChanged(const robot::RobotWatch& robot) { joints_ = robot.joints(); }
  /// As far as the robot has come until now.
  [[nodiscard]] path::DrivenPath driven() const;

 private:
  path::DrivenPath driven_;
  std::optional<arm::JointVector> joints_;  ///< that were streamed last [rad]
};

}  // namespace cobot_command::blocks
