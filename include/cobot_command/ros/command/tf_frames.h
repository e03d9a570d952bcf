// The frames of tf, seen from the base of one robot.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <ros/time.h>
#include <std_msgs/Header.h>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

/// Listens to tf on a thread of its own, as tf2 does; to begin with that takes the master, so that this is
/// done beside whoever asks, too. Its functions are for one thread, but for whereNow().
///
/// /tf is one topic for everybody: where N robots listen to it, each gets the frames of all, N times N
/// messages. Those that use no frames but their own need not listen.
class TfFrames {
 public:
  /// `from_start`: listen at once; else from the first find() on, which then knows nothing of earlier times.
  TfFrames(std::string robot_base, bool from_start);
  ~TfFrames();
  TfFrames(const TfFrames&) = delete;
  TfFrames& operator=(const TfFrames&) = delete;

  /// As a FrameLookup does.
  [[nodiscard]] FramePlace find(const std_msgs::Header& header);
  /// As a FrameFinder does, from any thread: tf2's buffer has a lock of its own. Knows nothing before find().
  [[nodiscard]] std::optional<arm::Pose> whereNow(const std::string& frame) const;
  /// How long a frame that is not known is worth waiting for.
  [[nodiscard]] Duration patience() const;

 private:
  void listen();

  class Listener;

  std::string robot_base_;
  std::shared_ptr<Listener> listener_;  ///< shared with the thread that makes it listen
  std::optional<ros::SteadyTime> asked_at_;
};

}  // namespace cobot_command::ros_adapter
