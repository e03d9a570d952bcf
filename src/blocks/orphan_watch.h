// A motion from before this connection (states: orphan_states.h): found once, told, and perhaps stopped.
#pragma once

#include "robot_watch.h"

#include "cobot_command/blocks/orphan_states.h"

namespace cobot_command::blocks {

class OrphanWatch {
 public:
  static constexpr const char* kText = "the robot moves, and no goal of this layer asked for it";

  void fire(OrphanEvent event);
  void see(const RobotWatch& robot);

  [[nodiscard]] bool moves() const { return state_ == OrphanState::Moving; }
  /// True once for each that is found.
  [[nodiscard]] bool takeFound();

 private:
  OrphanState state_ = OrphanState::NoLink;
  bool found_ = false;
};

}  // namespace cobot_command::blocks
