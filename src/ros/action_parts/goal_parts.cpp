#include "action_parts/goal_parts.h"

#include <utility>

namespace cobot_command::ros_adapter {

blocks::FramedPose toFramedPose(const geometry_msgs::PoseStamped& message, FramePlace place) {
  const auto& position = message.pose.position;
  const auto& quaternion = message.pose.orientation;
  blocks::FramedPose pose;
  pose.frame = message.header.frame_id;
  pose.position = {position.x, position.y, position.z};
  pose.quaternion = {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
  pose.frame_in_robot_base = std::move(place.in_robot_base);
  pose.fault = std::move(place.fault);
  pose.latest = message.header.stamp.isZero();
  return pose;
}

std::optional<blocks::FramedPose> toFramedPose(const geometry_msgs::PoseStamped& message,
                                               const FrameLookup& frames) {
  if (message.header.frame_id.empty()) return std::nullopt;
  return toFramedPose(message, frames(message.header));
}

}  // namespace cobot_command::ros_adapter
