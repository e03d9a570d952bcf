// Detects a motion from before this connection (states: orphan_states.h). It is found and reported once, and
// may be stopped.
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
  /// Text about it, for people; empty: there is none.
  [[nodiscard]] const char* text() const;
  /// True once for each motion that is found.
  [[nodiscard]] bool takeFound();

 private:
  OrphanState state_ = OrphanState::NoLink;
  bool found_ = false;
};

}  // namespace cobot_command::robot
