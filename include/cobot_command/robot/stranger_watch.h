// Whether somebody else commands the robot: reports of tags that nobody here opened, and motion while nothing
// of this layer is under way. Only told, never acted upon: what moves may be wanted.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class StrangerWatch {
 public:
  /// The report of a tag that can be none of ours.
  void tagReported(int tag) { tag_ = tag; }
  /// With each event: `ours`: whatever moves may be moved by this layer, or there is no link.
  void see(const RobotWatch& robot, bool ours, Instant now);
  /// Of another link nothing is known.
  void forget() { *this = StrangerWatch(); }

  /// For people; empty: nobody was noticed.
  [[nodiscard]] std::string text() const;

 private:
  std::optional<int> tag_;
  std::optional<Instant> idle_since_;  ///< nothing of ours is under way
  bool moves_ = false;
};

}  // namespace cobot_command::robot
