// Whether the robot is at standstill, from its status stream: no joint has moved for a while, or, sooner than
// that, every joint speed is almost zero.
//
// The joint speeds of a real arm at standstill are noise, which differs from arm to arm. The noise is learned
// from the speeds while the angles show a standstill. A speed above the learned noise is motion at once, and
// so is one above any possible noise. Below that the angles decide.
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

  /// nullopt: not known, or not known yet: by angles it takes some frames.
  [[nodiscard]] std::optional<bool> moving() const { return moving_; }

 private:
  struct Place {
    Instant at;
    arm::JointVector joints;
    double fastest;  ///< [rad/s]
  };
  void keep(const link::RobotStatus& status, double fastest);
  void judgeByAngles();
  /// nullopt: there are too few angles yet.
  [[nodiscard]] std::optional<bool> movingByAngles() const;

  std::optional<bool> moving_;
  /// Places of the time, and of the number of frames, that a decision needs; the first may be older.
  std::deque<Place> places_;
  /// The highest speed of any joint while the angles showed a standstill [rad/s].
  double noise_ = 0;
};

}  // namespace cobot_command::robot
