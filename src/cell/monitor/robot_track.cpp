#include "monitor/robot_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cobot_command/common/units.h"

namespace cobot_command::cell::monitor {
namespace {

constexpr double kMostJoint = 4 * kPi;  // no joint turns by more than 360 degrees [rad]
constexpr double kMostSpeed = 8 * kPi;  // the fastest joint does 450 degrees in a second [rad/s]

/// NaN is within nothing.
bool allWithin(const arm::JointVector& values, double most) {
  return (values.array().abs() <= most).all();
}

double squaredDistanceToAxis(const Eigen::Vector3d& point, const arm::JointAxis& axis) {
  return axis.direction.cross(point - axis.origin).squaredNorm();
}

}  // namespace

RobotTrack::RobotTrack(const RobotBodies& bare, std::vector<FlangeCapsules> may_carry,
                       const std::vector<double>& most_speeds)
    : Track(most_speeds), bare_(bare), may_carry_(std::move(may_carry)), robot_(bare_.carrying(may_carry_)) {}

Track::Taken RobotTrack::take(const arm::JointVector& joints,
                              const std::optional<arm::JointVector>& velocities, Duration age, Instant now,
                              Duration most) {
  const bool sound = allWithin(joints, kMostJoint) && (!velocities || allWithin(*velocities, kMostSpeed));
  if (!sound) return Taken::Malformed;
  return note(joints, velocities ? std::optional<Axes>(*velocities) : std::nullopt, age, now, most);
}

bool RobotTrack::carry(const std::optional<Carried>& parts) {
  std::vector<FlangeCapsules> carried;
  for (const FlangeCapsules& part : may_carry_) {
    if (!parts || parts->count(part.name) > 0) carried.push_back(part);
  }
  if (parts && carried.size() != parts->size()) return false;
  carried_ = parts;
  robot_ = bare_.carrying(carried);
  if (heard()) place();
  return true;
}

void RobotTrack::place() {
  robot_.place(values(), placed_);
  BodySet& set = bodies();
  set.capsules = placed_.capsules;
  set.fixed.clear();
  for (const Body& body : robot_.bodies()) set.fixed.push_back(isFixed(body) ? 1 : 0);
  set.standStill();
  set.encloseAll();
}

double RobotTrack::displacement(std::size_t body, double seconds) const {
  // From the joint next to the body down to the first: how far a point is from an axis depends on the joints
  // behind that axis alone, so by no more than they have moved it is farther than it was measured to be.
  double moved = 0;
  const Capsule& capsule = set().capsules[body];
  for (std::size_t joint = robot_.bodies()[body].link; joint-- > 0;) {
    const double angle = speed(joint) * seconds;
    if (angle == 0) continue;
    const arm::JointAxis& axis = placed_.axes[joint];
    const double core = std::sqrt(
        std::max(squaredDistanceToAxis(capsule.from, axis), squaredDistanceToAxis(capsule.to, axis)));
    moved += (core + capsule.radius + moved) * angle;
  }
  return moved;
}

}  // namespace cobot_command::cell::monitor
