// Whether a motion that should be under way has come to rest on its way: what another client's stop, which
// nobody reports, looks like from here.
#pragma once

#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class StallWatch {
 public:
  /// With each status frame since the command was sent.
  void see(const RobotWatch& robot, Instant now);
  /// The robot has moved since, and has stood for so long now, with no pause and no safeguard that holds it.
  /// Never without joint angles: by speeds alone a slow motion looks like rest.
  [[nodiscard]] bool stalled(Duration patience) const;
  /// It was looked into: the rest begins anew.
  void lookedInto() { rest_.reset(); }

 private:
  struct Rest {
    arm::JointVector place;
    Instant since;
    Instant last;
    int frames = 1;
  };
  std::optional<Rest> rest_;
  bool moved_ = false;
};

}  // namespace cobot_command::robot
