// The orderly shutdown of a node, the same for SIGINT, SIGTERM, SIGHUP and `rosnode kill`.
//
// roscpp handles only SIGINT. It removes all topics before anything can be published on them, also in a node
// that is still creating them: to publish on such a topic is a failed assertion. Here the node is notified
// first. It has its topics until it has ended, and completes its start before it ends.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

class NodeEnd {
 public:
  using Begun = std::function<void()>;

  /// Initializes ROS for a node of that name, and from before that on detects requests to end. Create it
  /// before everything that it must outlive. An ignored SIGHUP stays ignored (nohup). From the first request
  /// to end, whenever and however often it is made, the node has kFarewellPatience to reach leaveWithin() or
  /// to end. While it serves, this time begins when its shutdown has begun. After this time the process is
  /// ended as it is, with status 0.
  NodeEnd(int argc, char** argv, const std::string& name);
  ~NodeEnd();
  NodeEnd(const NodeEnd&) = delete;
  NodeEnd& operator=(const NodeEnd&) = delete;

  /// The end was requested, by a signal or through the master. Callable from any thread.
  [[nodiscard]] bool isAskedFor() const;

  /// Call it when the first node handle exists. Before it a request to end ends ROS, because ROS waits for a
  /// master without end. After it ROS continues, and the shutdown waits for serve(). False: the end was
  /// already requested, and ROS may have ended; create nothing more of it.
  [[nodiscard]] bool joined();

  /// Processes ROS's callbacks on the calling thread until the end is requested; none if it was requested
  /// before. At the request `begin` is called, at once and on another thread, for work that cannot wait until
  /// a callback has returned. It is not used any more when this returns. It must ensure that its argument is
  /// called, from any thread, when the shutdown has begun: a robot was sent a stop command. Until then the
  /// process is not ended, whatever the time, because nothing else would stop that robot; a line in the log
  /// reports this. Call it once, while a node handle exists.
  void serve(std::function<void(Begun)> begin);

  /// If the node has not ended within that time, ends the process as it is, with status 0 and a line on
  /// stderr about its last activity. Unregistering at a master that hangs would not end.
  void leaveWithin(Duration patience);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waits until all messages published before are handed to the operating system, as far as the subscribers
/// accept them; for at most `patience`. False: the time was too short. Without it, ros::shutdown() drops the
/// queued messages.
bool deliverPublished(Duration patience);

/// Enough for every subscriber that runs, and short enough for a robot's node to end in time.
inline constexpr Duration kDeliveryPatience = std::chrono::milliseconds(100);
/// Time for the master to process everything that a node unregisters.
inline constexpr Duration kFarewellPatience = std::chrono::seconds(3);

}  // namespace cobot_command::ros_adapter
