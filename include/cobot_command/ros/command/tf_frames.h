// The frames of tf, relative to the base of one robot.
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

/// Listens to tf on a thread of its own, as tf2 does. To begin listening it needs the master; this
/// does not block the caller either. All functions except whereNow() are for one thread.
///
/// /tf is one topic for all nodes: if N robots listen to it, each receives the frames of all, which makes N
/// times N messages. Robots that use only their own frames need not listen.
class TfFrames {
 public:
  /// `from_start`: listens at once; otherwise from the first find() on, which then has no earlier transforms.
  TfFrames(std::string robot_base, bool from_start);
  ~TfFrames();
  TfFrames(const TfFrames&) = delete;
  TfFrames& operator=(const TfFrames&) = delete;

  /// See FrameLookup.
  [[nodiscard]] FramePlace find(const std_msgs::Header& header);
  /// See FrameFinder. Callable from any thread, because the buffer of tf2 has its own lock. Finds nothing
  /// before find().
  [[nodiscard]] std::optional<arm::Pose> whereNow(const std::string& frame) const;
  /// Time for which it is useful to wait for an unknown frame.
  [[nodiscard]] Duration patience() const;

 private:
  void listen();

  class Listener;

  std::string robot_base_;
  std::shared_ptr<Listener> listener_;  ///< shared with the thread that makes it listen
  std::optional<ros::SteadyTime> asked_at_;
};

}  // namespace cobot_command::ros_adapter
