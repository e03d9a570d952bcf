// What a goal message may name that is not in it: frames of tf, files.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <std_msgs/Header.h>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/pick_and_place.h"
#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// Where a tf frame is; or in plain words why that is not known.
struct FramePlace {
  std::optional<arm::Pose> in_robot_base;  ///< [m]
  std::string fault;
};
/// Finds the frame of a header, at its stamp; zero: the latest. Answers at once.
using FrameLookup = std::function<FramePlace(const std_msgs::Header&)>;

/// The steps of a file; or in plain words, with its name, why there are none.
using StepsAnswer = Result<std::vector<blocks::PickAndPlaceStep>, std::string>;
/// Finds the file at a location. Answers at once: nothing means that it is still being read.
using StepsLookup = std::function<std::optional<StepsAnswer>(const std::string& location)>;

/// What a goal may name that is not in its message.
struct Lookups {
  FrameLookup frames;
  StepsLookup steps;
};

}  // namespace cobot_command::ros_adapter
