// General functions of scripts whose results the controller makes: its time, and random numbers.
#pragma once

#include <functional>

#include "cobot_command/language/functions.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::simulator {

/// random, GetNow, GetNowStamp. All numbers are the same on every run of the simulation.
void defineControllerFunctions(language::FunctionTable& functions, std::function<RobotState()> state);

}  // namespace cobot_command::simulator
