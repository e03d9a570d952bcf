// Steps that name a station where their block needs a pose.
#pragma once

#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// Gives each such step (Step::at) where the TCP is with the joints of its station, in the base and with the
/// TCP that are active by then. Precondition: the program has no fault.
void takeStationPoses(Robot& robot);

}  // namespace cobot_command::cell
