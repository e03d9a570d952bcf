// Work for the thread that serves a callback queue.
#pragma once

#include <cstdint>
#include <functional>

#include <ros/callback_queue_interface.h>

namespace cobot_command::ros_adapter {

/// Id for removeByID(), which removes the work posted for `owner`. The owner must call it before it is
/// destroyed.
[[nodiscard]] inline std::uint64_t ownerOf(const void* owner) {
  return reinterpret_cast<std::uintptr_t>(owner);
}

void post(ros::CallbackQueueInterface& queue, std::function<void()> what, const void* owner);

}  // namespace cobot_command::ros_adapter
