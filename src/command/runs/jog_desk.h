// Who holds a jog to run, from outside of its goal; and what its controller has refused.
#pragma once

#include "cobot_command/blocks/shared/path_controlled.h"
#include "cobot_command/common/time.h"

namespace cobot_command::command {

class JogDesk {
 public:
  /// Somebody holds whatever is under way; counts for the next serve().
  void keepAlive() { kept_ = true; }
  /// With every look at the time; nullptr: no jog is under way, and what was held is let go.
  void serve(blocks::JogControlled* jog, Instant now) {
    if (jog != nullptr && kept_) jog->keepAlive(now);
    kept_ = false;
    velocity_refused_ = velocity_refused_ || (jog != nullptr && jog->isVelocityRefused());
  }
  /// The controller takes no velocities, by what it has said since the link was made.
  [[nodiscard]] bool isVelocityRefused() const { return velocity_refused_; }
  void disconnected() { velocity_refused_ = false; }

 private:
  bool kept_ = false;
  bool velocity_refused_ = false;
};

}  // namespace cobot_command::command
