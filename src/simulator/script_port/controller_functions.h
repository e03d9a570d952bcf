// General functions of scripts whose results the controller makes: its time, and random numbers.
#pragma once

#include <functional>

#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::simulator {

/// random, GetNow, GetNowStamp. All numbers are the same on every run of the simulation.
void defineControllerFunctions(tm_script::FunctionTable& functions, const std::function<RobotState()>& state);

}  // namespace cobot_command::simulator
