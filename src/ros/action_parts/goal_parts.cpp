#include "action_parts/goal_parts.h"

#include <utility>

namespace cobot_command::ros_adapter {

std::optional<blocks::FramedPose> toFramedPose(const geometry_msgs::PoseStamped& message,
                                               const FrameLookup& frames) {
  if (message.header.frame_id.empty()) return std::nullopt;
  const auto& position = message.pose.position;
  const auto& quaternion = message.pose.orientation;
  FramePlace place = frames(message.header);
  blocks::FramedPose pose;
  pose.frame = message.header.frame_id;
  pose.position = {position.x, position.y, position.z};
  pose.quaternion = {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
  pose.frame_in_robot_base = std::move(place.in_robot_base);
  pose.fault = std::move(place.fault);
  pose.latest = message.header.stamp.isZero();
  return pose;
}

}  // namespace cobot_command::ros_adapter
