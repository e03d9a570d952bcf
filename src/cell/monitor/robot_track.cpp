#include "monitor/robot_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cobot_command/common/units.h"

namespace cobot_command::cell::monitor {
namespace {

constexpr double kMostJoint = 4 * kPi;  // no joint turns by more than 360 degrees [rad]
constexpr double kMostSpeed = 8 * kPi;  // the fastest joint does 450 degrees in a second [rad/s]
constexpr Duration kMostAge = std::chrono::hours(1);
/// Of joints measured closer to each other than this, the speed would be that of their last digits, and of
/// the network.
constexpr Duration kLeastApart = std::chrono::milliseconds(5);

/// NaN is within nothing.
bool allWithin(const arm::JointVector& values, double most) {
  return (values.array().abs() <= most).all();
}

double squaredDistanceToAxis(const Eigen::Vector3d& point, const arm::JointAxis& axis) {
  return axis.direction.cross(point - axis.origin).squaredNorm();
}

}  // namespace

RobotTrack::RobotTrack(const RobotBodies& bare, std::vector<FlangeCapsules> may_carry)
    : bare_(bare), may_carry_(std::move(may_carry)), robot_(bare_.carrying(may_carry_)) {}

RobotTrack::Taken RobotTrack::take(const arm::JointVector& joints,
                                   const std::optional<arm::JointVector>& velocities, Duration age,
                                   Instant now, Duration most) {
  const bool sound = allWithin(joints, kMostJoint) && (!velocities || allWithin(*velocities, kMostSpeed));
  if (!sound || age < Duration::zero() || age > kMostAge) return Taken::Malformed;
  const Instant measured = now - age;
  if (measured_ && measured <= *measured_) return Taken::Old;
  derive(joints, measured, most);
  speeds_ = derived_;
  if (velocities) {
    // Some tell zeros whatever the arm does.
    speeds_ = speeds_.cwiseMax(velocities->cwiseAbs());
  }
  speeds_known_ = derived_known_ || velocities;
  measured_ = measured;
  joints_ = joints;
  place();
  return Taken::Yes;
}

void RobotTrack::derive(const arm::JointVector& joints, Instant measured, Duration most) {
  const Duration apart = reference_ ? measured - reference_->measured : Duration::zero();
  if (reference_ && apart < kLeastApart) return;
  // What it did meanwhile says little of what it does now, when it was not heard for long.
  derived_known_ = reference_ && apart <= most;
  derived_.setZero();
  if (derived_known_) derived_ = (joints - reference_->joints).cwiseAbs() / toSeconds(apart);
  reference_ = Reference{measured, joints};
}

bool RobotTrack::carry(const Carried& parts) {
  std::vector<FlangeCapsules> carried;
  for (const FlangeCapsules& part : may_carry_) {
    if (parts.count(part.name) == 0) continue;
    carried.push_back(part);
  }
  if (carried.size() != parts.size()) return false;
  robot_ = bare_.carrying(carried);
  if (heard()) place();
  return true;
}

void RobotTrack::place() {
  robot_.place(joints_, placed_);
  set_.capsules = placed_.capsules;
  set_.fixed.clear();
  for (const Body& body : robot_.bodies()) set_.fixed.push_back(body.link == 0 ? 1 : 0);
  set_.growth.assign(set_.capsules.size(), 0.0);
  set_.most_growth = 0;
  set_.encloseAll();
}

void RobotTrack::grow(Duration age) {
  set_.most_growth = 0;
  for (std::size_t i = 0; i < set_.capsules.size(); ++i) {
    set_.growth[i] = displacement(i, toSeconds(age));
    set_.most_growth = std::max(set_.most_growth, set_.growth[i]);
  }
}

double RobotTrack::displacement(std::size_t body, double seconds) const {
  // From the joint next to the body down to the first: how far a point is from an axis depends on the joints
  // behind that axis alone, so by no more than they have moved it is farther than it was measured to be.
  double moved = 0;
  const Capsule& capsule = set_.capsules[body];
  for (std::size_t joint = robot_.bodies()[body].link; joint-- > 0;) {
    const double angle = speeds_[static_cast<Eigen::Index>(joint)] * seconds;
    if (angle == 0) continue;
    const arm::JointAxis& axis = placed_.axes[joint];
    const double core = std::sqrt(
        std::max(squaredDistanceToAxis(capsule.from, axis), squaredDistanceToAxis(capsule.to, axis)));
    moved += (core + capsule.radius + moved) * angle;
  }
  return moved;
}

Duration RobotTrack::age(Instant now) const {
  return std::max(Duration::zero(), now - *measured_);
}

bool RobotTrack::moves(double standing_speed) const {
  return heard() && (!speeds_known_ || speeds_.maxCoeff() > standing_speed);
}

}  // namespace cobot_command::cell::monitor
