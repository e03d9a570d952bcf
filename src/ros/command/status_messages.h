// What the command layer tells everyone, as messages.
#pragma once

#include <string>
#include <vector>

#include <ros/time.h>
#include <visualization_msgs/Marker.h>

#include "cobot_command/ActiveFrames.h"
#include "cobot_command/CommandStatus.h"
#include "cobot_command/FrameTrace.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::CommandStatus toMessage(const command::CommandStatus& status,
                                                     const ClockPair& clocks);
[[nodiscard]] cobot_command::FrameTrace toMessage(const command::FrameTraced& trace, const ClockPair& clocks);
/// `base_frame`: the tf frame of the robot base.
[[nodiscard]] cobot_command::ActiveFrames toMessage(const robot::ActiveFrames& frames,
                                                    const std::string& base_frame, const ros::Time& stamp);
/// A line through the points of the tool; with fewer than two of them it takes the last line away.
[[nodiscard]] visualization_msgs::Marker toMarker(const std::vector<arm::Pose>& tool_path,
                                                  const std::string& base_frame, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
