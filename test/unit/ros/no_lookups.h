// For goals of which nothing is to be looked up.
#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

inline FramePlace noFrame(const std_msgs::Header& /*header*/) {
  ADD_FAILURE() << "no frame is to be looked up";
  return {};
}

inline std::optional<StepsAnswer> noSteps(const std::string& /*location*/) {
  ADD_FAILURE() << "no file of steps is to be read";
  return std::nullopt;
}

inline std::optional<PointsAnswer> noPoints(const std::string& /*location*/) {
  ADD_FAILURE() << "no file of points is to be read";
  return std::nullopt;
}

}  // namespace cobot_command::ros_adapter
