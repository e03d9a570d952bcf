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
  if (state_ == OrphanState::Moving) return "the robot moves, and no goal of this layer asked for it";
  if (state_ == OrphanState::Held) {
    return "the robot is held, by a pause or a safeguard, and what was queued before this connection may go "
           "on";
  }
  if (state_ == OrphanState::Unseen) {
    return "the robot moved when it was last seen, and no goal of this layer asked for it: the status stream "
           "has to show it standing, or a stop to be executed";
  }
  return "";
}

bool OrphanWatch::takeFound() {
  return std::exchange(found_, false);
}

}  // namespace cobot_command::robot
