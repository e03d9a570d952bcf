// What the command layer tells everyone, as messages.
#pragma once

#include <string>

#include <ros/time.h>

#include "cobot_command/ActiveFrames.h"
#include "cobot_command/CommandStatus.h"
#include "cobot_command/DigitalIo.h"
#include "cobot_command/FrameTrace.h"
#include "cobot_command/GroupState.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::CommandStatus toMessage(const command::CommandStatus& status,
                                                     const ClockPair& clocks);
[[nodiscard]] cobot_command::FrameTrace toMessage(const command::FrameTraced& trace, const ClockPair& clocks);
[[nodiscard]] cobot_command::GroupState toMessage(const command::GroupState& state, const ros::Time& stamp);
[[nodiscard]] cobot_command::DigitalIo toMessage(const link::DigitalLevels& inputs,
                                                 const link::DigitalLevels& outputs, const ros::Time& stamp);
/// `base_frame`: the tf frame of the robot base.
[[nodiscard]] cobot_command::ActiveFrames toMessage(const robot::ActiveFrames& frames,
                                                    const std::string& base_frame, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
