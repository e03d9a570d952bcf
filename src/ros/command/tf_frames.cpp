#include "cobot_command/ros/command/tf_frames.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <tf2/exceptions.h>

#include "cobot_command/common/given.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

// The frames of a robot that moves come late by some tens of milliseconds, those of a node that has just
// started by a few hundred.
constexpr auto kPatience = std::chrono::milliseconds(200);
// Whoever has just begun to listen has first to connect to all who send.
constexpr auto kFirstPatience = std::chrono::seconds(3);

}  // namespace

TfFrames::TfFrames(std::string robot_base, bool from_start) : robot_base_(std::move(robot_base)) {
  if (from_start) listen();
}

void TfFrames::listen() {
  listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_);
  listening_since_ = ros::SteadyTime::now();
}

Duration TfFrames::patience() const {
  const Duration listened((ros::SteadyTime::now() - listening_since_).toNSec());
  return std::max<Duration>(kPatience, kFirstPatience - listened);
}

FramePlace TfFrames::find(const std_msgs::Header& header) {
  const std::string& frame = header.frame_id;
  // tf2 says so as well, but its text ends where the right name should stand.
  if (frame.compare(0, 1, "/") == 0) {
    return {std::nullopt,
            fmt::format("frames of tf have no / in front; is {} meant?", quoted(frame.substr(1)))};
  }
  if (!listener_) listen();
  try {
    return {toPose(buffer_.lookupTransform(robot_base_, frame, header.stamp).transform), ""};
  } catch (const tf2::TransformException& fault) {
    return {std::nullopt, fault.what()};
  }
}

std::optional<arm::Pose> TfFrames::whereNow(const std::string& frame) const {
  try {
    return toPose(buffer_.lookupTransform(robot_base_, frame, ros::Time(0)).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace cobot_command::ros_adapter
