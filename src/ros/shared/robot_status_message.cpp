#include "shared/robot_status_message.h"

#include <cstdint>
#include <optional>

namespace cobot_command::ros_adapter {
namespace {

std::int8_t triState(const std::optional<bool>& value) {
  using Message = cobot_command::RobotStatus;
  if (!value) return Message::UNKNOWN;
  return *value ? Message::TRUE : Message::FALSE;
}

}  // namespace

cobot_command::RobotStatus toMessage(const link::RobotStatus& status, const std::optional<bool>& moving,
                                     const ros::Time& stamp) {
  using Message = cobot_command::RobotStatus;
  Message message;
  message.header.stamp = stamp;
  const int mode = status.operating_mode.value_or(0);
  message.mode = mode == 1   ? Message::MODE_AUTOMATIC
                 : mode == 2 ? Message::MODE_MANUAL
                             : Message::MODE_UNKNOWN;
  message.e_stopped = triState(status.emergency_stop);
  message.safeguard = triState(status.safeguard);
  message.in_motion = triState(moving);
  message.in_error = triState(status.error);
  message.error_code = status.error_code.value_or(0);
  message.error_text = status.error_text.value_or("");
  message.project_running = triState(status.project_running);
  message.project_paused = triState(status.project_paused);
  message.project_speed = status.project_speed_percent.value_or(-1);
  message.base_name = status.base_name.value_or("");
  message.tcp_name = status.tcp_name.value_or("");
  return message;
}

}  // namespace cobot_command::ros_adapter
