// Whether the robot stands, by what its status stream shows: no joint has moved for a while; or, sooner than
// that, every joint speed is next to nothing.
//
// The joint speeds of a real arm that stands are noise, and no two arms have the same. It is learned from
// what this one showed while its angles told that it stood: a speed above that is motion at once, and so is
// one that is above any noise; below it the angles tell.
#pragma once

#include <deque>
#include <optional>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::robot {

class Standstill {
 public:
  void see(const link::RobotStatus& status);
  /// The stream stopped.
  void forget() { *this = Standstill(); }

  /// Nothing when it cannot be told, or not yet: by angles it takes some frames.
  [[nodiscard]] std::optional<bool> moving() const { return moving_; }

 private:
  struct Place {
    Instant at;
    arm::JointVector joints;
    double fastest;  ///< [rad/s]
  };
  void keep(const link::RobotStatus& status, double fastest);
  void judgeByAngles();
  /// Nothing: there is too little of them yet.
  [[nodiscard]] std::optional<bool> movingByAngles() const;

  std::optional<bool> moving_;
  std::deque<Place> places_;  ///< of as long as it takes to tell, and as many; the first may be older
  double noise_ = 0;  ///< the fastest that any joint seemed to be while the angles told of rest [rad/s]
};

}  // namespace cobot_command::robot
