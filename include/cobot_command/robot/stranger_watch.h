// Detects that another client commands the robot: reports of tags that this layer did not open, and motion
// while no command of this layer is running. It only reports; it never acts, because the motion may be
// wanted.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class StrangerWatch {
 public:
  /// A report of a tag that cannot belong to this layer.
  void tagReported(int tag) { tag_ = tag; }
  /// Call it for each event. `ours`: this layer may cause any motion, or there is no link.
  void see(const RobotWatch& robot, bool ours, Instant now);
  /// Nothing is known about a new link.
  void forget() { *this = StrangerWatch(); }

  /// For people; empty: no other client was detected.
  [[nodiscard]] std::string text() const;

 private:
  std::optional<int> tag_;
  std::optional<Instant> idle_since_;  ///< since then no command of this layer is running
  bool moves_ = false;
};

}  // namespace cobot_command::robot
