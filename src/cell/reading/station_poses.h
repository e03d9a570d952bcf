// Steps that name a station where their block needs a pose.
#pragma once

#include <map>
#include <string>

#include "checks/step_checks.h"

namespace cobot_command::cell {

/// Gives each such step (Step::at) where the TCP is with the joints of its station, in the base and with the
/// TCP that are active by then, to millionths as scripts have it. `at_stations`: what is active there.
/// Precondition: the program has no fault.
void takeStationPoses(Robot& robot, const std::map<std::string, ActiveFrames>& at_stations);

}  // namespace cobot_command::cell
