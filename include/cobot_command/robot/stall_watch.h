// Detects that a motion that should be running has come to rest on its path. This is the effect of a stop by
// another client, which no message reports.
#pragma once

#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class StallWatch {
 public:
  /// Call it for each status frame after the command was sent.
  void see(const RobotWatch& robot, Instant now);
  /// True: the robot has been at standstill for `patience`, without a pause or a safeguard. Always false
  /// without joint angles, because by speeds alone a slow motion looks like rest.
  [[nodiscard]] bool rests(Duration patience) const;
  /// The same for a robot that has moved before, and `patience` after the last examination.
  [[nodiscard]] bool stalled(Duration patience) const;
  /// The standstill was examined: stalled() waits again.
  void lookedInto();

 private:
  struct Rest {
    arm::JointVector place;
    Instant since;
    Instant last;
    Instant examined;  ///< or `since`
    int frames = 1;
  };
  std::optional<Rest> rest_;
  bool moved_ = false;
};

}  // namespace cobot_command::robot
