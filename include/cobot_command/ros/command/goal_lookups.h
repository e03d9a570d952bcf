// Data that a goal message may name but does not contain: frames of tf, files.
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

/// Where a tf frame is, or in plain words why this is unknown.
struct FramePlace {
  std::optional<arm::Pose> in_robot_base;  ///< [m]
  std::string fault;
};
/// Finds the frame of a header, at its stamp; stamp zero: the latest transform. Returns at once.
using FrameLookup = std::function<FramePlace(const std_msgs::Header&)>;

/// The content of a file, or in plain words why there is none, with the file's name.
using StepsAnswer = Result<std::vector<blocks::PickAndPlaceStep>, std::string>;
using PointsAnswer = Result<std::vector<path::PathPoint>, std::string>;
/// Steps: a file with the steps of a cycle. Points: a file with the points of a path.
enum class FileKind { Steps, Points };
/// The alternative depends on the kind of the file.
using FileAnswer = std::variant<StepsAnswer, PointsAnswer>;
// Find the file at a location. They return at once; nullopt: it is still being read.
using StepsLookup = std::function<std::optional<StepsAnswer>(const std::string& location)>;
using PointsLookup = std::function<std::optional<PointsAnswer>(const std::string& location)>;

/// Access to all data that a goal may name but its message does not contain.
struct Lookups {
  FrameLookup frames;
  StepsLookup steps;
  PointsLookup points;
  std::string world_frame = "world";  ///< reference of the poses of paths in WORLD
};

}  // namespace cobot_command::ros_adapter
