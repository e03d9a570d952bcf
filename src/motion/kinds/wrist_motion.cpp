#include "kinds/wrist_motion.h"

#include <limits>
#include <memory>
#include <utility>

#include "kinds/ramped_motion.h"
#include "paths/input_check.h"
#include "paths/path_refusals.h"
#include "paths/path_trajectory.h"
#include <Eigen/LU>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/wrist_inverse.h"

namespace cobot_command::motion {
namespace {

class WristPostures final : public PathPostures {
 public:
  /// `tcp` in the flange.
  WristPostures(const arm::ArmModel& arm, const arm::JointVector& start, const arm::JointVector& target,
                const arm::Pose& tcp)
      : arm_(arm),
        tool_(tcp),
        inverse_(arm, tcp),
        branch_(inverse_.branchOf(start)),
        start_(start),
        from_(placeOf(start)),
        way_(placeOf(target) - from_),
        turn_((target - start).tail<3>()) {}

  [[nodiscard]] const arm::ArmModel& arm() const override { return arm_; }
  [[nodiscard]] double length() const override { return way_.norm(); }
  [[nodiscard]] double turn() const override { return turn_.cwiseAbs().sum(); }
  [[nodiscard]] double longestTurn() const { return turn_.cwiseAbs().maxCoeff(); }

  [[nodiscard]] arm::Pose tcpAt(double progress) const override {
    const auto joints = at(progress, start_);
    arm::Pose pose = arm::forwardKinematics(arm_, joints ? *joints : start_) * tool_;
    pose.translation() = placeAt(progress);
    return pose;
  }
  [[nodiscard]] Result<arm::JointVector, Refusal::Reason> at(
      double progress, const arm::JointVector& reference) const override {
    const Eigen::Vector3d wrist = start_.tail<3>() + progress * turn_;
    if (const auto joints = inverse_.solve(wrist, placeAt(progress), branch_, reference)) return *joints;
    const bool reachable = !inverse_.solutions(wrist, placeAt(progress)).empty();
    return refuse(reachable ? Refusal::Reason::PoseBits : Refusal::Reason::Unreachable);
  }
  /// What J1..J3 have to make is the way of the tool without what J4..J6 make of it.
  [[nodiscard]] arm::JointVector velocityAt(double progress, double rate,
                                            const arm::JointVector& joints) const override {
    const Eigen::Vector3d to_tool = placeAt(progress) - arm::forwardKinematics(arm_, joints).translation();
    const arm::Jacobian jacobian = arm::jacobianAt(arm_, joints);
    Eigen::Matrix<double, 3, 6> of_place = jacobian.topRows<3>();
    for (Eigen::Index i = 0; i < of_place.cols(); ++i) {
      of_place.col(i) += jacobian.col(i).tail<3>().cross(to_tool);
    }
    arm::JointVector velocity;
    velocity.tail<3>() = rate * turn_;
    const Eigen::Vector3d rest = rate * way_ - of_place.rightCols<3>() * velocity.tail<3>();
    velocity.head<3>() = of_place.leftCols<3>().partialPivLu().solve(rest);
    return velocity;
  }
  /// The place, and each of J4..J6 by itself: both at one rate.
  [[nodiscard]] PathEquation equationAt(double progress, const arm::JointVector& joints) const override {
    const Eigen::Vector3d to_tool = placeAt(progress) - arm::forwardKinematics(arm_, joints).translation();
    PathEquation equation{arm::jacobianAt(arm_, joints), {}, {}, false};
    equation.axes = equation.jacobian.bottomRows<3>();
    for (Eigen::Index i = 0; i < joints.size(); ++i) {
      equation.jacobian.col(i).head<3>() += equation.jacobian.col(i).tail<3>().cross(to_tool);
    }
    equation.jacobian.bottomRows<3>() << Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Identity();
    equation.rate << way_, turn_;
    return equation;
  }
  [[nodiscard]] RateChange rateChange(double /*from*/, double /*to*/) const override { return {}; }
  [[nodiscard]] arm::SingularityDistance singularityDistance(const arm::JointVector& joints) const override {
    const arm::WristSingularityDistance distance = inverse_.singularityDistance(joints);
    return {distance.shoulder, distance.elbow, std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] std::string kept() const override { return "the shoulder and elbow of the start"; }

 private:
  [[nodiscard]] Eigen::Vector3d placeOf(const arm::JointVector& joints) const {
    return (arm::forwardKinematics(arm_, joints) * tool_).translation();
  }
  [[nodiscard]] Eigen::Vector3d placeAt(double progress) const { return from_ + progress * way_; }

  arm::ArmModel arm_;
  arm::Pose tool_;
  arm::WristArm inverse_;
  arm::WristBranch branch_;
  arm::JointVector start_;
  Eigen::Vector3d from_;  // in the robot base
  Eigen::Vector3d way_;
  Eigen::Vector3d turn_;  // of J4..J6
};

}  // namespace

Result<TrajectoryPtr, Refusal> planWristMove(const arm::ArmModel& arm, const arm::JointVector& start,
                                             const WristMove& move, const Setting& setting) {
  if (auto outside = targetOutsideLimits(arm, move.target, setting)) return refuse(std::move(*outside));
  const auto postures = std::make_shared<const WristPostures>(arm, start, move.target, setting.tcp);
  const double turn = postures->longestTurn();
  const ProfilePtr profile = profileOf(postures->length(), turn, move.rates, setting.speed_override);
  const AskedSpeed asked =
      askedSpeed(postures->length(), turn, move.rates, profile->travel() * setting.speed_override);
  auto made = follow(postures, start, profile, {"wrist move", asked, setting.base});
  if (!made) return made;
  const arm::Pose there = setting.base.inverse() * tcpInRobotBase(arm, move.target, setting);
  if (auto other = otherPosture((*made)->end().position, move.target, there)) {
    return refuse(std::move(*other));
  }
  return made;
}

}  // namespace cobot_command::motion
