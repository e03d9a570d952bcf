#include "cobot_command/arm/inverse_kinematics.h"

#include <algorithm>
#include <cmath>

#include "rigid_transform.h"

#include "cobot_command/common/units.h"

// The names are those of doc/kinematics.md, where the derivation stands.
namespace cobot_command::arm {
namespace {

using Eigen::Vector3d;

/// Each is far above the rounding of a pose and far below 1e-9 m or rad in its effect on the answer.
constexpr double kCylinderTolerance = 1e-12;  ///< of the squared radius of the shoulder cylinder [m2]
constexpr double kCylinderRounding = 1e-15;   ///< within it the wrist centre is on the cylinder [m2]
constexpr double kElbowTolerance = 1e-10;     ///< of the cosine of joint 3
constexpr double kWristTolerance = 1e-12;     ///< of the sine of joint 5
constexpr double kNearWristTolerance =
    1e-10;  ///< of the orientation, where joint 6 is badly determined [rad]
/// Sine of joint 5 below which joint 6 is so badly determined that it may put axis 4 out of reach.
constexpr double kNearWrist = 1e-3;

/// In (-pi, pi], for an angle in (-3 pi, 3 pi].
double wrapped(double angle) {
  if (angle > kPi) return angle - 2 * kPi;
  if (angle <= -kPi) return angle + 2 * kPi;
  return angle;
}

/// A vector in the plane in which the joints 2 to 4 move.
struct InPlane {
  double forward = 0;  ///< along x1, the direction in which joint 1 points
  double up = 0;

  /// From the vertical, as the joints 2 to 4 count.
  [[nodiscard]] double angle() const { return std::atan2(forward, up); }
  [[nodiscard]] double squaredNorm() const { return forward * forward + up * up; }
};

/// One of the two solutions for joint 1, and what follows from it.
struct ShoulderSide {
  Shoulder bit = Shoulder::Righty;
  double joint_1 = 0;
  InPlane wrist_centre;  ///< seen from the shoulder [m]
  InPlane flange_x;
  InPlane flange_y;
  double sin_5 = 0;  ///< of the solution with joint 5 in [0, pi]
  double cos_5 = 0;
  double x_across = 0;  ///< parts of the flange's x and y along axis 2
  double y_across = 0;
};

/// One of the two solutions for the joints 5 and 6.
struct WristSide {
  Wrist bit = Wrist::NoFlip;
  double joint_5 = 0;
  double joint_6 = 0;
  double axis_5_angle = 0;  ///< the sum of the joints 2 to 4
  InPlane axis_5;
};

class Solver {
 public:
  /// `wanted`: the only branch to look for; nothing: all.
  Solver(const DhLengths& lengths, const Pose& flange, double reference_6,
         const std::optional<PoseBits>& wanted)
      : lengths_(lengths),
        flange_(flange),
        reference_6_(reference_6),
        wanted_(wanted),
        wrist_centre_(flange.translation() - lengths.d6 * flange.linear().col(2) -
                      Vector3d(0, 0, lengths.d1)) {}

  Branches solve() {
    const double squared_radius = wrist_centre_.head<2>().squaredNorm();
    const double squared_distance = squared_radius - lengths_.d4 * lengths_.d4;
    if (!(squared_distance >= -kCylinderTolerance)) return {};
    const double distance = squared_distance > kCylinderRounding ? std::sqrt(squared_distance) : 0.0;
    const double scale = 1 / std::sqrt(squared_radius * (distance * distance + lengths_.d4 * lengths_.d4));
    addShoulderSide(Shoulder::Righty, distance, scale);
    addShoulderSide(Shoulder::Lefty, -distance, scale);
    return branches_;
  }

 private:
  [[nodiscard]] bool wants(Shoulder bit) const { return !wanted_ || wanted_->shoulder == bit; }
  [[nodiscard]] bool wants(Elbow bit) const { return !wanted_ || wanted_->elbow == bit; }
  [[nodiscard]] bool wants(Wrist bit) const { return !wanted_ || wanted_->wrist == bit; }

  /// `distance` is s, with its sign; `scale` makes the direction of joint 1 a unit vector.
  void addShoulderSide(Shoulder bit, double distance, double scale) {
    if (!wants(bit)) return;
    const double c1 = (distance * wrist_centre_.x() + lengths_.d4 * wrist_centre_.y()) * scale;
    const double s1 = (distance * wrist_centre_.y() - lengths_.d4 * wrist_centre_.x()) * scale;
    const auto in_plane = [c1, s1](const auto& v) { return InPlane{c1 * v.x() + s1 * v.y(), v.z()}; };
    const auto across = [c1, s1](const auto& v) { return c1 * v.y() - s1 * v.x(); };
    const auto x = flange_.linear().col(0);
    const auto y = flange_.linear().col(1);

    ShoulderSide side;
    side.bit = bit;
    side.joint_1 = std::atan2(s1, c1);
    side.wrist_centre = in_plane(wrist_centre_);
    side.flange_x = in_plane(x);
    side.flange_y = in_plane(y);
    side.x_across = across(x);
    side.y_across = across(y);
    side.sin_5 = std::sqrt(side.x_across * side.x_across + side.y_across * side.y_across);
    side.cos_5 = -across(flange_.linear().col(2));
    if (side.sin_5 > kWristTolerance) {
      addBothWristSides(side);
    } else {
      addSingularWristSides(side);
    }
  }

  void addBothWristSides(const ShoulderSide& shoulder) {
    const double c6 = shoulder.x_across / shoulder.sin_5;
    const double s6 = -shoulder.y_across / shoulder.sin_5;
    WristSide wrist;
    // Both sine and cosine: from the cosine alone, half the digits would be lost near the singularity.
    wrist.joint_5 = std::atan2(shoulder.sin_5, shoulder.cos_5);
    wrist.joint_6 = std::atan2(s6, c6);
    wrist.axis_5 = {s6 * shoulder.flange_x.forward + c6 * shoulder.flange_y.forward,
                    s6 * shoulder.flange_x.up + c6 * shoulder.flange_y.up};
    wrist.axis_5_angle = wrist.axis_5.angle();
    const bool righty = shoulder.bit == Shoulder::Righty;
    wrist.bit = righty ? Wrist::NoFlip : Wrist::Flip;
    addElbows(shoulder, wrist);

    // The other side: axis 5 the other way round.
    wrist.bit = righty ? Wrist::Flip : Wrist::NoFlip;
    wrist.joint_5 = -wrist.joint_5;
    wrist.joint_6 = wrapped(wrist.joint_6 + kPi);
    wrist.axis_5 = {-wrist.axis_5.forward, -wrist.axis_5.up};
    wrist.axis_5_angle = wrapped(wrist.axis_5_angle + kPi);
    addElbows(shoulder, wrist);
  }

  /// Axis 6 is parallel to the axes 2 to 4: joint 6 is free, both wrist sides are the same posture.
  void addSingularWristSides(const ShoulderSide& shoulder) {
    WristSide wrist;
    wrist.joint_5 = std::atan2(shoulder.sin_5, shoulder.cos_5);
    wrist.axis_5_angle = shoulder.flange_y.angle();
    turnAxis5(shoulder, wrist, senseOfJoint6(shoulder) * reference_6_);
    for (const Wrist bit : {Wrist::NoFlip, Wrist::Flip}) {
      wrist.bit = bit;
      addElbows(shoulder, wrist);
    }
  }

  /// With the axes 2 to 4 parallel to axis 6, joint 6 turns axis 5 forwards (1) or backwards (-1).
  static double senseOfJoint6(const ShoulderSide& shoulder) { return shoulder.cos_5 > 0 ? 1 : -1; }

  static void turnAxis5(const ShoulderSide& shoulder, WristSide& wrist, double change) {
    wrist.axis_5_angle = std::remainder(wrist.axis_5_angle + change, 2 * kPi);
    wrist.axis_5 = {std::sin(wrist.axis_5_angle), std::cos(wrist.axis_5_angle)};
    wrist.joint_6 = std::remainder(wrist.joint_6 + senseOfJoint6(shoulder) * change, 2 * kPi);
  }

  /// Near the wrist singularity rounding alone turns axis 5, at the singularity joint 6 is free: neither may
  /// put axis 4 out of reach. Turns axis 5 by as little as brings axis 4 back, if the pose allows it.
  void bringAxis4IntoReach(const ShoulderSide& shoulder, WristSide& wrist) const {
    const double squared_distance = shoulder.wrist_centre.squaredNorm();
    const auto angle_for = [&](double tube) {  // between wrist centre and axis 5, when axis 4 is `tube` away
      const double cosine = (squared_distance + lengths_.d5 * lengths_.d5 - tube * tube) /
                            (2 * std::sqrt(squared_distance) * lengths_.d5);
      return std::acos(std::min(std::max(cosine, -1.0), 1.0));
    };
    const double from_centre = std::remainder(wrist.axis_5_angle - shoulder.wrist_centre.angle(), 2 * kPi);
    const double reachable = std::min(std::max(std::abs(from_centre), angle_for(lengths_.a2 - lengths_.a3)),
                                      angle_for(lengths_.a2 + lengths_.a3));
    const double change = std::copysign(reachable, from_centre) - from_centre;
    if (shoulder.sin_5 * std::abs(change) <= kNearWristTolerance) turnAxis5(shoulder, wrist, change);
  }

  void addElbows(const ShoulderSide& shoulder, WristSide wrist) {
    if (!wants(wrist.bit)) return;
    if (shoulder.sin_5 < kNearWrist) bringAxis4IntoReach(shoulder, wrist);
    const InPlane axis_4 = {shoulder.wrist_centre.forward - lengths_.d5 * wrist.axis_5.forward,
                            shoulder.wrist_centre.up - lengths_.d5 * wrist.axis_5.up};
    const double a2 = lengths_.a2;
    const double a3 = lengths_.a3;
    double cos_3 = (axis_4.squaredNorm() - a2 * a2 - a3 * a3) / (2 * a2 * a3);
    if (!(std::abs(cos_3) <= 1 + kElbowTolerance)) return;
    cos_3 = std::min(std::max(cos_3, -1.0), 1.0);
    // As a product, so that no digits cancel when the arm is nearly straight.
    const double sin_3 = std::sqrt((1 - cos_3) * (1 + cos_3));
    const double joint_3 = std::atan2(sin_3, cos_3);
    const double middle = axis_4.angle();
    const double aside = std::atan2(a3 * sin_3, a2 + a3 * cos_3);
    const bool righty = shoulder.bit == Shoulder::Righty;
    add(shoulder, wrist, middle - aside, joint_3, righty ? Elbow::Above : Elbow::Below);
    add(shoulder, wrist, middle + aside, -joint_3, righty ? Elbow::Below : Elbow::Above);
  }

  void add(const ShoulderSide& shoulder, const WristSide& wrist, double joint_2, double joint_3,
           Elbow elbow) {
    if (!wants(elbow)) return;
    Branch& branch = branches_.emplace_back();
    joint_2 = wrapped(joint_2);
    joint_3 = wrapped(joint_3);
    branch.joints << shoulder.joint_1, joint_2, joint_3, wrapped(wrist.axis_5_angle - joint_2 - joint_3),
        wrapped(wrist.joint_5), wrapped(wrist.joint_6);
    branch.bits = {shoulder.bit, elbow, wrist.bit};
  }

  const DhLengths& lengths_;
  const Pose& flange_;
  double reference_6_;
  const std::optional<PoseBits>& wanted_;
  Vector3d wrist_centre_;  ///< seen from the shoulder [m]
  Branches branches_;
};

}  // namespace

namespace {

Branches branches(const ArmModel& arm, const Pose& flange, const JointVector& reference,
                  const std::optional<PoseBits>& wanted) {
  if (!isRigidTransform(flange)) return {};
  return Solver(arm.lengths(), flange, std::isfinite(reference[5]) ? reference[5] : 0.0, wanted).solve();
}

}  // namespace

Branches allBranches(const ArmModel& arm, const Pose& flange, const JointVector& reference) {
  return branches(arm, flange, reference, std::nullopt);
}

std::optional<JointVector> branchWith(const ArmModel& arm, const Pose& flange, const PoseBits& bits,
                                      const JointVector& reference) {
  const Branches found = branches(arm, flange, reference, bits);
  return found.empty() ? std::nullopt : std::optional(found.front().joints);
}

}  // namespace cobot_command::arm
