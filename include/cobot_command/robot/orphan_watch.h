// A motion from before this connection (states: orphan_states.h): found once, told, and perhaps stopped.
#pragma once

#include "cobot_command/robot/orphan_states.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class OrphanWatch {
 public:
  void fire(OrphanEvent event);
  void see(const RobotWatch& robot);

  [[nodiscard]] bool mayMove() const {
    return state_ == OrphanState::Moving || state_ == OrphanState::Held || state_ == OrphanState::Unseen;
  }
  /// What is to be told of it; empty: nothing.
  [[nodiscard]] const char* text() const;
  /// True once for each that is found.
  [[nodiscard]] bool takeFound();

 private:
  OrphanState state_ = OrphanState::NoLink;
  bool found_ = false;
};

}  // namespace cobot_command::robot
