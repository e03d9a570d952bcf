// Items of the status stream -> RobotStatus: the controller's units become SI here.
#pragma once

#include <vector>

#include "cobot_command/link/robot_status.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::link {

/// Items that are not known, whose value has not the size of their type, or has a number that is not finite,
/// are left out; the latter two are named in RobotStatus::unreadable. Units on the wire:
/// mm, deg, deg/s, mNm (TM 3.1).
[[nodiscard]] RobotStatus toRobotStatus(const std::vector<protocol::StatusItem>& items, Instant received);

}  // namespace cobot_command::link
