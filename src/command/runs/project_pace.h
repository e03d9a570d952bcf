// At which project speed a command is made: the one that the controller has as its motion begins, which the
// status stream shows a little later than that.
#pragma once

#include <optional>

#include "forecast/command_order.h"

#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class ProjectPace {
 public:
  /// With each status frame while the command is under way. `executed`: for how long it should have been,
  /// below zero before. From where, and with which speed, it is to be planned anew, once for each speed.
  [[nodiscard]] std::optional<Origin> see(const CommandOrder& order, const robot::RobotWatch& robot,
                                          Duration executed);

 private:
  std::optional<double> planned_for_;  ///< anew; nothing: as it was sent
  bool is_seen_ = false;               ///< it has begun, and the stream has had time to show that
};

}  // namespace cobot_command::command
