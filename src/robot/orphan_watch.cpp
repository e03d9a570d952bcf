#include "cobot_command/robot/orphan_watch.h"

#include <utility>

namespace cobot_command::robot {

void OrphanWatch::fire(OrphanEvent event) {
  const auto row = findTransition<OrphanTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  if (row->action == OrphanAction::Found) found_ = true;
}

void OrphanWatch::see(const RobotWatch& robot) {
  const auto moving = robot.moving();
  if (!moving) {
    fire(OrphanEvent::OutOfSight);
  } else if (*moving) {
    fire(OrphanEvent::SeenMoving);
  } else {
    fire(robot.held() ? OrphanEvent::SeenHeld : OrphanEvent::SeenStanding);
  }
}

const char* OrphanWatch::text() const {
  if (state_ == OrphanState::Moving) return "the robot moves, and no goal of this layer requested it";
  if (state_ == OrphanState::Held) {
    return "the robot is paused or stopped by a safeguard, and motions queued before this connection may "
           "continue";
  }
  if (state_ == OrphanState::Unseen) {
    return "the robot moved when it was last seen, and no goal of this layer requested it: the status stream "
           "must show it at standstill, or a stop must be executed";
  }
  return "";
}

bool OrphanWatch::takeFound() {
  return std::exchange(found_, false);
}

}  // namespace cobot_command::robot
