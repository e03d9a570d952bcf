// The orderly end of a node, alike for SIGINT, SIGTERM, SIGHUP and `rosnode kill`.
//
// roscpp knows of SIGINT only, and takes all topics away before anything can be said on them. Here the node
// hears first: it has its topics until it has ended.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

class NodeEnd {
 public:
  /// To be made behind ros::init() with NoSigintHandler, and before anything that it shall outlive. A SIGHUP
  /// that is ignored stays ignored (nohup). Until serve() a signal ends ROS: ros::ok() becomes false.
  NodeEnd();
  ~NodeEnd();
  NodeEnd(const NodeEnd&) = delete;
  NodeEnd& operator=(const NodeEnd&) = delete;

  /// Serves ROS's callbacks on the calling thread, until somebody asks for the end. `begin` is called then,
  /// at once and on another thread: for what cannot wait until a callback has returned. Further signals
  /// change nothing. To be called once, with a node handle alive.
  void serve(std::function<void()> begin);

  /// Leaves the process as it is, with status 0, when it has not ended by itself in that time: to say goodbye
  /// to a master that hangs would take for ever.
  void leaveWithin(Duration patience);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waits until what was published before is with the system, as far as the subscribers take it; for at most
/// `patience`. False: the time did not suffice. Without it, ros::shutdown() drops what is still queued.
bool deliverPublished(Duration patience);

/// Enough for every subscriber that is alive, and short enough for a robot's node to end in time.
inline constexpr Duration kDeliveryPatience = std::chrono::milliseconds(100);
/// What the master has for all that a node takes back.
inline constexpr Duration kFarewellPatience = std::chrono::seconds(3);

}  // namespace cobot_command::ros_adapter
