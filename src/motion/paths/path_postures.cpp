#include "paths/path_postures.h"

#include <cmath>
#include <utility>

#include <Eigen/LU>
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

arm::JointVector turnedTo(const arm::JointVector& reference, arm::JointVector joints) {
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const double gap = reference[i] - joints[i];
    if (std::abs(gap) > kPi) {
      joints[i] += 2.0 * kPi * std::round(gap / (2.0 * kPi));
    }
  }
  return joints;
}

}  // namespace

CurvePostures::CurvePostures(const arm::ArmModel& arm, TcpCurvePtr curve, const arm::Pose& tcp,
                             const arm::PoseBits& bits)
    : arm_(arm), curve_(std::move(curve)), flange_in_tcp_(tcp.inverse()), bits_(bits) {}

Result<arm::JointVector, Refusal::Reason> CurvePostures::at(double progress,
                                                            const arm::JointVector& reference) const {
  const arm::Pose flange = curve_->at(progress) * flange_in_tcp_;
  if (const auto joints = arm::branchWith(arm_, flange, bits_, reference)) {
    return turnedTo(reference, *joints);
  }
  const bool reachable = !arm::allBranches(arm_, flange, reference).empty();
  return refuse(reachable ? Refusal::Reason::PoseBits : Refusal::Reason::Unreachable);
}

arm::JointVector CurvePostures::velocityAt(double progress, double rate,
                                           const arm::JointVector& joints) const {
  PathRate twist = rate * curve_->rateAt(progress);
  const arm::Pose tcp = curve_->at(progress);
  const Eigen::Vector3d tcp_to_flange = tcp.linear() * flange_in_tcp_.translation();
  twist.head<3>() += twist.tail<3>().cross(tcp_to_flange);
  return arm::jacobianAt(arm_, joints).partialPivLu().solve(twist);
}

PathEquation CurvePostures::equationAt(double progress, const arm::JointVector& joints) const {
  const Eigen::Vector3d to_flange = curve_->at(progress).linear() * flange_in_tcp_.translation();
  PathEquation equation{arm::jacobianAt(arm_, joints), {}, curve_->rateAt(progress)};
  equation.axes = equation.jacobian.bottomRows<3>();
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    equation.jacobian.col(i).head<3>() += to_flange.cross(equation.jacobian.col(i).tail<3>());
  }
  return equation;
}

std::string CurvePostures::kept() const {
  return fmt::format("the pose bits of the start ({})", arm::toString(bits_));
}

}  // namespace cobot_command::motion
