// Which posture follows a TCP path: always the one with the same pose bits, and without a jump of a whole
// turn.
#pragma once

#include "curves/tcp_curve.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::motion {

/// A value; immutable.
class PathPostures {
 public:
  /// `path` of the TCP in the robot base; `tcp` in the flange.
  PathPostures(const arm::ArmModel& arm, TcpCurvePtr path, const arm::Pose& tcp, const arm::PoseBits& bits);

  [[nodiscard]] const arm::ArmModel& arm() const { return arm_; }
  [[nodiscard]] const TcpCurve& path() const { return *path_; }
  [[nodiscard]] const arm::PoseBits& bits() const { return bits_; }

  /// The posture at `progress`, each joint at the turn nearest to `reference`, whatever the limits. Refused
  /// as Unreachable or PoseBits.
  [[nodiscard]] Result<arm::JointVector, Refusal::Reason> at(double progress,
                                                             const arm::JointVector& reference) const;

  /// The joint speeds [rad/s] at `progress`, where the posture is `joints`, when the progress grows by `rate`
  /// [1/s]. Precondition: no singularity.
  [[nodiscard]] arm::JointVector velocityAt(double progress, double rate,
                                            const arm::JointVector& joints) const;

 private:
  arm::ArmModel arm_;
  TcpCurvePtr path_;
  arm::Pose flange_in_tcp_;
  arm::PoseBits bits_;
};

}  // namespace cobot_command::motion
