#include "family_geometry.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <kdl/frames.hpp>

#include "cobot_command/common/units.h"

namespace cobot_command::arm {
namespace {

constexpr double kTolerance = 1e-6;
/// Below this length of an arm tube the elbow is no longer determined.
constexpr double kShortestTube = 1e-3;
/// Of any of the lengths; more is one in mm.
constexpr double kMostLength = 10;

/// The line that a joint turns about, with all joints at zero, in the base.
struct Axis {
  KDL::Vector point;
  KDL::Vector direction;
};

struct ZeroPosture {
  std::array<Axis, kJointCount> axes;
  KDL::Frame flange;
};

ZeroPosture zeroPostureOf(const KDL::Chain& chain) {
  ZeroPosture zero;
  std::size_t count = 0;
  for (const KDL::Segment& segment : chain.segments) {
    const KDL::Joint& joint = segment.getJoint();
    if (joint.getType() != KDL::Joint::None && count < kJointCount) {
      zero.axes[count++] = {zero.flange * joint.JointOrigin(), zero.flange.M * joint.JointAxis()};
    }
    zero.flange = zero.flange * segment.pose(0.0);
  }
  return zero;
}

/// Axes 2..4 lie across, one above the other; axis 5 stands upright beside them; axis 6 lies across again.
DhLengths measure(const ZeroPosture& zero) {
  const auto& axes = zero.axes;
  DhLengths lengths;
  lengths.d1 = axes[1].point.z();
  lengths.a2 = axes[2].point.z() - axes[1].point.z();
  lengths.a3 = axes[3].point.z() - axes[2].point.z();
  lengths.d4 = axes[4].point.y();
  lengths.d5 = axes[5].point.z() - axes[3].point.z();
  lengths.d6 = lengths.d4 - zero.flange.p.y();
  return lengths;
}

std::array<Axis, kJointCount> familyAxes(const DhLengths& lengths) {
  const double shoulder = lengths.d1;
  const double elbow = shoulder + lengths.a2;
  const double wrist = elbow + lengths.a3;
  const KDL::Vector up(0, 0, 1);
  const KDL::Vector left(0, 1, 0);
  return {{{{0, 0, 0}, up},
           {{0, 0, shoulder}, left},
           {{0, 0, elbow}, left},
           {{0, 0, wrist}, left},
           {{0, lengths.d4, 0}, up},
           {{0, 0, wrist + lengths.d5}, -left}}};
}

double distanceFromLine(const KDL::Vector& point, const Axis& line) {
  return ((point - line.point) * line.direction).Norm();
}

ModelError outOfPlace(const std::string& part, double metres, double radians) {
  return {fmt::format(
      "{} is {:.3g} m and {:.3g} rad away from where the TM family has it (allowed: {:g} m and {:g} rad), "
      "so the closed-form kinematics would be wrong. Use the nominal geometry of doc/kinematics.md; "
      "only its six lengths may differ.",
      part, metres, radians, kTolerance, kTolerance)};
}

}  // namespace

Result<DhLengths, ModelError> lengthsOfFamilyMember(const KDL::Chain& chain) {
  const ZeroPosture zero = zeroPostureOf(chain);
  const DhLengths lengths = measure(zero);
  const auto expected = familyAxes(lengths);
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const double metres = distanceFromLine(zero.axes[i].point, expected[i]);
    const double radians = (zero.axes[i].direction - expected[i].direction).Norm();
    // Not "greater than": a NaN must be refused too.
    if (!(metres <= kTolerance && radians <= kTolerance)) {
      return refuse(outOfPlace(fmt::format("The axis of joint {}", i + 1), metres, radians));
    }
  }
  const KDL::Frame flange(KDL::Rotation::RotX(kPi / 2),
                          {0, lengths.d4 - lengths.d6, lengths.d1 + lengths.a2 + lengths.a3 + lengths.d5});
  const KDL::Twist deviation = KDL::diff(flange, zero.flange);
  if (!(deviation.vel.Norm() <= kTolerance && deviation.rot.Norm() <= kTolerance)) {
    return refuse(outOfPlace("The flange", deviation.vel.Norm(), deviation.rot.Norm()));
  }
  if (!(lengths.a2 >= kShortestTube && lengths.a3 >= kShortestTube && lengths.d4 <= -kShortestTube)) {
    return refuse(
        ModelError{fmt::format("The lengths a2 = {} m, a3 = {} m, d4 = {} m are not those of a TM arm: a2 "
                               "and a3 must be above {} m, d4 "
                               "below {} m. Correct the origins of elbow_joint and wrist_1_joint.",
                               lengths.a2, lengths.a3, lengths.d4, kShortestTube, -kShortestTube)});
  }
  for (const double length : {lengths.d1, lengths.a2, lengths.a3, lengths.d4, lengths.d5, lengths.d6}) {
    if (!(std::abs(length) <= kMostLength)) {
      return refuse(
          ModelError{fmt::format("A length of the arm is {} m, but at most {} m are allowed. Give the "
                                 "origins of its joints in metres.",
                                 length, kMostLength)});
    }
  }
  return lengths;
}

}  // namespace cobot_command::arm
