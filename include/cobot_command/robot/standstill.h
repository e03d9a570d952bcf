// Whether the robot stands, by what its status stream tells: the joint speeds, or, where the data table has
// none, how far the joint angles of its frames differ.
#pragma once

#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::robot {

/// Joint angles that differ by less show the same place: what a joint at the speed below which it counts as
/// standing makes in a tenth of a second.
inline constexpr double kSamePlace = degToRad(0.01);  // [rad]

class Standstill {
 public:
  void see(const link::RobotStatus& status);
  /// The stream stopped.
  void forget() { *this = Standstill(); }

  /// Nothing when it cannot be told, or not yet: without speeds it takes some frames.
  [[nodiscard]] std::optional<bool> moving() const { return moving_; }

 private:
  /// Where the joints were when they were last seen to be elsewhere than before.
  struct Rest {
    arm::JointVector joints;
    Instant since;
    int frames = 1;
  };
  void follow(const arm::JointVector& joints, Instant received);

  std::optional<bool> moving_;
  std::optional<Rest> rest_;
};

}  // namespace cobot_command::robot
