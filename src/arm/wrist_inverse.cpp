#include "cobot_command/arm/wrist_inverse.h"

#include <algorithm>
#include <cmath>

#include "cobot_command/common/units.h"

// The names are those of doc/kinematics.md, where the derivation stands.
namespace cobot_command::arm {
namespace {

using Eigen::Vector3d;

/// An origin that is out of reach by no more is at the edge: far above the rounding of a place [m].
constexpr double kEdge = 1e-11;
/// A forearm that is shorter has no direction [m].
constexpr double kNoForearm = 1e-9;

double principal(double angle) {
  const double rest = std::remainder(angle, 2 * kPi);
  return rest <= -kPi ? kPi : rest;
}

double nearestTurnTo(double reference, double angle) {
  return angle + 2 * kPi * std::nearbyint((reference - angle) / (2 * kPi));
}

}  // namespace

WristArm::WristArm(const ArmModel& arm, const Pose& tool)
    : lengths_(arm.lengths()), tool_(tool.translation()) {}

WristArm::Forearm WristArm::forearmWith(const Vector3d& wrist) const {
  const double c4 = std::cos(wrist[0]);
  const double s4 = std::sin(wrist[0]);
  const double c5 = std::cos(wrist[1]);
  const double s5 = std::sin(wrist[1]);
  const double c6 = std::cos(wrist[2]);
  const double s6 = std::sin(wrist[2]);
  // The parts of the tool and of d6 along axis 5 (uF), across it in the plane of the arm (u') and along z1.
  const double along_x0 = c6 * tool_.x() - s6 * tool_.y();  // x of the flange while joint 6 is at zero
  const double along_z = lengths_.d6 + tool_.z();
  const double along_axis_5 = lengths_.d5 + s6 * tool_.x() + c6 * tool_.y();
  const double aside = s5 * along_z + c5 * along_x0;
  const double forearm = lengths_.a3 + c4 * along_axis_5 - s4 * aside;
  const double turned = s4 * along_axis_5 + c4 * aside;
  return {std::sqrt(forearm * forearm + turned * turned), std::atan2(turned, forearm),
          lengths_.d4 + s5 * along_x0 - c5 * along_z};
}

std::optional<WristArm::InPlane> WristArm::shoulderSide(const Forearm& forearm,
                                                        const Vector3d& origin) const {
  const double across = std::abs(forearm.across);
  const double radius = std::sqrt(origin.head<2>().squaredNorm());
  if (!(radius >= across - kEdge)) return std::nullopt;
  return InPlane{std::sqrt(std::max(radius - across, 0.0) * (radius + across)), origin.z() - lengths_.d1};
}

std::optional<WristArm::Bend> WristArm::bendFor(const Forearm& forearm, const InPlane& place) const {
  if (!(forearm.length > kNoForearm)) return std::nullopt;
  const double distance = std::sqrt(place.forward * place.forward + place.up * place.up);
  const double stretched = lengths_.a2 + forearm.length;
  const double folded = std::abs(lengths_.a2 - forearm.length);
  if (!(distance <= stretched + kEdge && distance >= folded - kEdge)) return std::nullopt;
  // 1 - cosine and 1 + cosine as products, so that no digits cancel when the arm is nearly straight.
  const double doubled = 2 * lengths_.a2 * forearm.length;
  const double above = std::max(stretched - distance, 0.0) * (stretched + distance) / doubled;
  const double below = std::max(distance - folded, 0.0) * (distance + folded) / doubled;
  return Bend{std::sqrt(above * below), (below - above) / 2};
}

Vector3d WristArm::armJoints(const Forearm& forearm, const Vector3d& origin, InPlane place, Bend bend,
                             const WristBranch& branch) const {
  if (!branch.in_front) place.forward = -place.forward;
  if (!branch.bent_forward) bend.sine = -bend.sine;
  // One arc tangent of the difference: its result needs no turns taken off.
  const double joint_1 = std::atan2(place.forward * origin.y() - forearm.across * origin.x(),
                                    place.forward * origin.x() + forearm.across * origin.y());
  const double joint_2 = std::atan2(place.forward, place.up) -
                         std::atan2(forearm.length * bend.sine, lengths_.a2 + forearm.length * bend.cosine);
  return {joint_1, joint_2, std::atan2(bend.sine, bend.cosine) - forearm.delta};
}

WristSolutions WristArm::solutions(const Vector3d& wrist, const Vector3d& origin) const {
  const Forearm forearm = forearmWith(wrist);
  const auto place = shoulderSide(forearm, origin);
  const auto bend = place ? bendFor(forearm, *place) : std::nullopt;
  WristSolutions found;
  if (!bend) return found;
  for (const bool in_front : {true, false}) {
    for (const bool bent_forward : {true, false}) {
      const WristBranch branch{in_front, bent_forward};
      const Vector3d arm = armJoints(forearm, origin, *place, *bend, branch).unaryExpr(&principal);
      WristSolution& solution = found.emplace_back();
      solution.joints << arm, wrist;
      solution.branch = branch;
    }
  }
  return found;
}

std::optional<JointVector> WristArm::solve(const Vector3d& wrist, const Vector3d& origin,
                                           const WristBranch& branch, const JointVector& reference) const {
  const Forearm forearm = forearmWith(wrist);
  const auto place = shoulderSide(forearm, origin);
  const auto bend = place ? bendFor(forearm, *place) : std::nullopt;
  if (!bend) return std::nullopt;
  Vector3d arm = armJoints(forearm, origin, *place, *bend, branch);
  if (origin.x() == 0 && origin.y() == 0) arm[0] = reference[0];
  for (Eigen::Index i = 0; i < arm.size(); ++i) arm[i] = nearestTurnTo(reference[i], arm[i]);
  JointVector joints;
  joints << arm, wrist;
  if (!joints.allFinite()) return std::nullopt;
  return joints;
}

WristArm::Place WristArm::placeOf(const JointVector& joints) const {
  const Forearm forearm = forearmWith(joints.tail<3>());
  const double bend = joints[2] + forearm.delta;
  const double forward = lengths_.a2 * std::sin(joints[1]) + forearm.length * std::sin(joints[1] + bend);
  return {forward, forearm.length > kNoForearm ? std::sin(bend) : 0.0};
}

WristBranch WristArm::branchOf(const JointVector& joints) const {
  const Place place = placeOf(joints);
  return {place.forward > 0, place.sine > 0};
}

WristSingularityDistance WristArm::singularityDistance(const JointVector& joints) const {
  const Place place = placeOf(joints);
  return {std::abs(place.forward), std::abs(place.sine)};
}

}  // namespace cobot_command::arm
