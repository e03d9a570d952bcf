// Which posture follows a path of the TCP, and how: whatever of it the check and the trajectory need.
#pragma once

#include <memory>
#include <string>

#include "curves/tcp_curve.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::motion {

/// What the joints of a path do for each unit of its progress, at one posture: jacobian * joints' = rate.
struct PathEquation {
  arm::Jacobian jacobian;            ///< rows 0..2 those of the TCP in the robot base
  Eigen::Matrix<double, 3, 6> axes;  ///< of the joints, likewise
  PathRate rate;
  bool turns = true;  ///< rows 3..5 are these axes, so depend on the posture; else they are constant
};

/// Immutable.
class PathPostures {
 public:
  virtual ~PathPostures() = default;

  [[nodiscard]] virtual const arm::ArmModel& arm() const = 0;
  /// At least the length of the TCP's way [m] and the sum of the turns [rad].
  [[nodiscard]] virtual double length() const = 0;
  [[nodiscard]] virtual double turn() const = 0;
  /// The TCP in the robot base.
  [[nodiscard]] virtual arm::Pose tcpAt(double progress) const = 0;

  /// The posture at `progress`, each joint at the turn nearest to `reference`, whatever the limits. Refused
  /// as Unreachable or PoseBits.
  [[nodiscard]] virtual Result<arm::JointVector, Refusal::Reason> at(
      double progress, const arm::JointVector& reference) const = 0;
  /// The joint speeds [rad/s] at `progress`, where the posture is `joints`, when the progress grows by `rate`
  /// [1/s]. Precondition: no singularity.
  [[nodiscard]] virtual arm::JointVector velocityAt(double progress, double rate,
                                                    const arm::JointVector& joints) const = 0;
  /// What velocityAt() solves; and at most how much its rate changes between two places, `from` < `to`.
  [[nodiscard]] virtual PathEquation equationAt(double progress, const arm::JointVector& joints) const = 0;
  [[nodiscard]] virtual RateChange rateChange(double from, double to) const = 0;
  /// From what this path cannot pass.
  [[nodiscard]] virtual arm::SingularityDistance singularityDistance(
      const arm::JointVector& joints) const = 0;
  /// What a path keeps from its start to its end, for messages: "the pose bits of the start (0,2,4)".
  [[nodiscard]] virtual std::string kept() const = 0;
};

using PathPosturesPtr = std::shared_ptr<const PathPostures>;

/// Along a curve of the TCP, always with the same pose bits, and without a jump of a whole turn.
class CurvePostures final : public PathPostures {
 public:
  /// `curve` of the TCP in the robot base; `tcp` in the flange.
  CurvePostures(const arm::ArmModel& arm, TcpCurvePtr curve, const arm::Pose& tcp, const arm::PoseBits& bits);

  [[nodiscard]] const arm::ArmModel& arm() const override { return arm_; }
  [[nodiscard]] double length() const override { return curve_->length(); }
  [[nodiscard]] double turn() const override { return curve_->turn(); }
  [[nodiscard]] arm::Pose tcpAt(double progress) const override { return curve_->at(progress); }
  [[nodiscard]] Result<arm::JointVector, Refusal::Reason> at(
      double progress, const arm::JointVector& reference) const override;
  [[nodiscard]] arm::JointVector velocityAt(double progress, double rate,
                                            const arm::JointVector& joints) const override;
  [[nodiscard]] PathEquation equationAt(double progress, const arm::JointVector& joints) const override;
  [[nodiscard]] RateChange rateChange(double from, double to) const override {
    return curve_->rateChange(from, to);
  }
  [[nodiscard]] arm::SingularityDistance singularityDistance(const arm::JointVector& joints) const override {
    return arm::singularityDistance(arm_, joints);
  }
  [[nodiscard]] std::string kept() const override;

 private:
  arm::ArmModel arm_;
  TcpCurvePtr curve_;
  arm::Pose flange_in_tcp_;
  arm::PoseBits bits_;
};

}  // namespace cobot_command::motion
