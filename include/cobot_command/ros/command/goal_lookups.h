// What a goal message may name that is not in it: frames of tf, files.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <std_msgs/Header.h>

#include "cobot_command/arm/types.h"
#include "cobot_command/blocks/load_path.h"
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

/// What a file holds; or in plain words, with its name, why there is nothing.
using StepsAnswer = Result<std::vector<blocks::PickAndPlaceStep>, std::string>;
using PointsAnswer = Result<std::vector<path::PathPoint>, std::string>;
/// The first has the steps of a cycle, the second the points of a path.
enum class FileKind { Steps, Points };
/// As the kind of the file says.
using FileAnswer = std::variant<StepsAnswer, PointsAnswer>;
// They find the file at a location. They answer at once: nothing means that it is still being read.
using StepsLookup = std::function<std::optional<StepsAnswer>(const std::string& location)>;
using PointsLookup = std::function<std::optional<PointsAnswer>(const std::string& location)>;

/// What a goal may name that is not in its message.
struct Lookups {
  FrameLookup frames;
  StepsLookup steps;
  PointsLookup points;
  std::string world_frame = "world";  ///< that poses of paths in WORLD are in
};

}  // namespace cobot_command::ros_adapter
