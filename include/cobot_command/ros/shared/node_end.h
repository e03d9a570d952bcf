// The orderly end of a node, alike for SIGINT, SIGTERM, SIGHUP and `rosnode kill`.
//
// roscpp knows of SIGINT only, and takes all topics away before anything can be said on them, also from a
// node that is still making them: what it then publishes on is none, which is an assertion. Here the node
// hears first: it has its topics until it has ended, and comes to the end of its start before it ends.
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

  /// Initializes ROS, for a node of that name, and from before that on hears who asks for the end. To be made
  /// before anything that it shall outlive. A SIGHUP that is ignored stays ignored (nohup). Whenever the end
  /// is asked for, and however often, the node has kFarewellPatience from the first time until it has come to
  /// leaveWithin(), or has ended; while it serves, from when its end has begun. Then the process is left as
  /// it is, with status 0.
  NodeEnd(int argc, char** argv, const std::string& name);
  ~NodeEnd();
  NodeEnd(const NodeEnd&) = delete;
  NodeEnd& operator=(const NodeEnd&) = delete;

  /// The end has been asked for: by a signal, or by way of the master. From any thread.
  [[nodiscard]] bool isAskedFor() const;

  /// To be called when the first node handle is there. Until then asking ends ROS, as that waits for a master
  /// for ever; from here on ROS stays, and the end waits for serve(). False: the end is asked for already,
  /// and ROS may be gone; make nothing more of it.
  [[nodiscard]] bool joined();

  /// Serves ROS's callbacks on the calling thread, until somebody asks for the end; not at all if somebody
  /// has. `begin` is called then, at once and on another thread, for what cannot wait until a callback has
  /// returned; when this returns it is not used any more. It has to see to it that what it is given is
  /// called, from any thread, when the end has begun: a robot has been told to stop. Until then the process
  /// is not left, however long it takes, as nobody else would stop that robot; a line in the log says so. To
  /// be called once, with a node handle alive.
  void serve(std::function<void(Begun)> begin);

  /// Leaves the process as it is, with status 0 and a line on stderr of what it was at, when it has not ended
  /// by itself in that time: to say goodbye to a master that hangs would take for ever.
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
