// What is known of one robot that is watched: where it was measured, when, and how fast.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/body_set.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

class RobotTrack {
 public:
  enum class Taken { Yes, Malformed, Old };

  RobotTrack(const RobotBodies& bare, std::vector<FlangeCapsules> may_carry);

  /// As Monitor::take(). The speed of a joint is the greater one of what is told and of what it did since
  /// data that is older by more than some noise, and by no more than `most`.
  Taken take(const arm::JointVector& joints, const std::optional<arm::JointVector>& velocities, Duration age,
             Instant now, Duration most);
  /// False: there is no such part.
  bool carry(const Carried& parts);
  /// Lets the bodies grow by what they may have moved since they were measured, at the speeds of then.
  void grow(Duration age);

  [[nodiscard]] bool heard() const { return measured_.has_value(); }
  [[nodiscard]] Instant measured() const { return *measured_; }
  /// How old what is known is; never negative.
  [[nodiscard]] Duration age(Instant now) const;
  /// By what is known of it, however old.
  [[nodiscard]] bool moves(double standing_speed) const;
  [[nodiscard]] const BodySet& set() const { return set_; }
  [[nodiscard]] const std::string& bodyName(std::size_t body) const { return robot_.bodies()[body].name; }

 private:
  void place();
  void derive(const arm::JointVector& joints, Instant measured, Duration most);
  [[nodiscard]] double displacement(std::size_t body, double seconds) const;

  RobotBodies bare_;
  std::vector<FlangeCapsules> may_carry_;
  RobotBodies robot_;  ///< with what it carries
  std::optional<Instant> measured_;
  arm::JointVector joints_ = arm::JointVector::Zero();
  arm::JointVector speeds_ = arm::JointVector::Zero();  ///< none negative [rad/s]
  bool speeds_known_ = false;
  arm::JointVector derived_ = arm::JointVector::Zero();
  bool derived_known_ = false;
  /// What speeds are derived from.
  struct Reference {
    Instant measured;
    arm::JointVector joints;
  };
  std::optional<Reference> reference_;
  PlacedRobot placed_;
  BodySet set_;
};

}  // namespace cobot_command::cell::monitor
