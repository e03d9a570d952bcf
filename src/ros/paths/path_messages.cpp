#include "paths/path_messages.h"

#include <cstdint>

namespace cobot_command::ros_adapter {
cobot_command::PathStatus toMessage(const blocks::PathStatus& status, const ros::Time& stamp) {
  cobot_command::PathStatus message;
  message.header.stamp = stamp;
  message.path_planner_active = status.path_planner_active;
  message.active_move_id = status.active_move_id;
  message.active_interpolation = static_cast<std::uint8_t>(status.active_interpolation);
  message.active_type = static_cast<std::uint8_t>(status.active_type);
  message.active_type_id = status.active_type_id;
  message.active_ref_frame_type = static_cast<std::uint8_t>(status.active_ref_frame_type);
  message.active_ref_frame_id = status.active_ref_frame_id;
  message.active_move_percent = status.active_move_percent;
  message.blending_move_id = status.blending_move_id;
  message.blending_move_percent = status.blending_move_percent;
  message.linear_velocity = status.linear_velocity;
  message.linear_acceleration = status.linear_acceleration;
  message.angular_velocity = status.angular_velocity;
  message.angular_acceleration = status.angular_acceleration;
  message.feedrate = status.feedrate;
  message.feedrate_effective = status.feedrate_effective;
  message.gate_waits = status.gate_waits;
  message.progress_source = static_cast<std::uint8_t>(status.source);
  return message;
}

}  // namespace cobot_command::ros_adapter
