// What is known of one robot that is watched: a track by its joints, with what it carries.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/track.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

class RobotTrack : public Track {
 public:
  RobotTrack(const RobotBodies& bare, std::vector<FlangeCapsules> may_carry,
             const std::vector<double>& most_speeds);

  /// As Monitor::take(). The speed of a joint is that of Track::note().
  Taken take(const arm::JointVector& joints, const std::optional<arm::JointVector>& velocities, Duration age,
             Instant now, Duration most);
  /// Nothing: all that it may carry. False: there is no such part.
  bool carry(const std::optional<Carried>& parts);
  [[nodiscard]] const std::optional<Carried>& carried() const { return carried_; }

  [[nodiscard]] const std::string& bodyName(std::size_t body) const override {
    return robot_.bodies()[body].name;
  }

 private:
  void place() override;
  [[nodiscard]] double displacement(std::size_t body, double seconds) const override;

  RobotBodies bare_;
  std::vector<FlangeCapsules> may_carry_;
  std::optional<Carried> carried_;
  RobotBodies robot_;  ///< with that
  PlacedRobot placed_;
};

}  // namespace cobot_command::cell::monitor
