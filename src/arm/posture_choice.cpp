// From all branches to the one posture that was asked for.
#include <algorithm>
#include <cmath>
#include <vector>

#include "rigid_transform.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::arm {
namespace {

constexpr double kTurn = 2 * kPi;
constexpr double kLimitTolerance = 1e-9;  ///< as ArmModel::firstJointOutsideLimits()

/// The angle at the turn that is inside the limits and then nearest to the reference; the angle itself when
/// no turn is inside, and at exactly half a turn from the reference.
double nearestTurn(double angle, const JointLimit& limit, double reference) {
  const double fewest = std::ceil((limit.lower - kLimitTolerance - angle) / kTurn);
  const double most = std::floor((limit.upper + kLimitTolerance - angle) / kTurn);
  if (!(fewest <= most)) return angle;
  const double nearest = std::nearbyint((reference - angle) / kTurn);
  return angle + kTurn * std::min(std::max(nearest, fewest), most);
}

JointVector withNearestTurns(const ArmModel& arm, const JointVector& joints, const JointVector& reference) {
  JointVector result;
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    result[i] = nearestTurn(joints[i], arm.limits()[static_cast<std::size_t>(i)], reference[i]);
  }
  return result;
}

IkRefusal refusal(IkRefusal::Reason reason, std::string message, int joint = -1) {
  return {reason, joint, std::move(message)};
}

IkRefusal notFinite() {
  return refusal(
      IkRefusal::Reason::NotFinite,
      "The flange pose or the reference posture is not finite, or the pose's axes are not a rotation. "
      "Give finite numbers and a rotation.");
}

IkRefusal outOfReach(const ArmModel& arm, const Pose& flange) {
  const DhLengths& lengths = arm.lengths();
  const Eigen::Vector3d centre = flange.translation() - lengths.d6 * flange.linear().col(2);
  const Eigen::Vector3d from_shoulder = centre - Eigen::Vector3d(0, 0, lengths.d1);
  const double reach = std::hypot(lengths.a2 + lengths.a3 + lengths.d5, lengths.d4);
  return refusal(
      IkRefusal::Reason::OutOfReach,
      fmt::format(
          "No posture of the {} brings the flange to X {:.2f}, Y {:.2f}, Z {:.2f} mm in this orientation: "
          "its wrist "
          "centre would be {:.2f} mm from axis 1 (at least {:.2f}) and {:.2f} mm from the shoulder (at most "
          "{:.2f}, less when the wrist is bent). Choose a pose nearer to the middle of the working range.",
          arm.name(), mToMm(flange.translation().x()), mToMm(flange.translation().y()),
          mToMm(flange.translation().z()), mToMm(centre.head<2>().norm()), mToMm(std::abs(lengths.d4)),
          mToMm(from_shoulder.norm()), mToMm(reach)));
}

IkRefusal bitsNotPossible(const PoseBits& wanted, const Branches& branches) {
  std::vector<std::string> possible;
  for (const Branch& branch : branches) possible.push_back(toString(branch.bits));
  return refusal(IkRefusal::Reason::BitsNotPossible,
                 fmt::format("The pose cannot be reached {}; possible are: {}. Choose one of these.",
                             toString(wanted), fmt::join(possible, ", ")));
}

IkRefusal outsideLimits(const ArmModel& arm, const JointVector& joints, int joint) {
  const JointLimit& limit = arm.limits()[static_cast<std::size_t>(joint)];
  return refusal(
      IkRefusal::Reason::OutsideLimits,
      fmt::format(
          "Joint {} would be at {:.3f} degrees, outside {:.3f} to {:.3f} degrees. Choose another pose or "
          "other pose bits.",
          joint + 1, radToDeg(joints[joint]), radToDeg(limit.lower), radToDeg(limit.upper)),
      joint);
}

}  // namespace

std::optional<JointVector> nearestTurn(const ArmModel& arm, const JointVector& joints,
                                       const JointVector& reference) {
  const JointVector turned = withNearestTurns(arm, joints, reference);
  if (arm.firstJointOutsideLimits(turned) >= 0) return std::nullopt;
  return turned;
}

Result<JointVector, IkRefusal> postureFor(const ArmModel& arm, const Pose& flange, const PoseBits& bits,
                                          const JointVector& reference) {
  if (!isRigidTransform(flange) || !reference.allFinite()) return refuse(notFinite());
  const auto joints = branchWith(arm, flange, bits, reference);
  if (!joints) {
    const Branches others = allBranches(arm, flange, reference);
    return refuse(others.empty() ? outOfReach(arm, flange) : bitsNotPossible(bits, others));
  }
  const JointVector turned = withNearestTurns(arm, *joints, reference);
  const int outside = arm.firstJointOutsideLimits(turned);
  if (outside >= 0) return refuse(outsideLimits(arm, turned, outside));
  return turned;
}

}  // namespace cobot_command::arm
