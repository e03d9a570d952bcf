// The joints that follow a TCP curve in time, checked wholly before the start.
#pragma once

#include "curves/tcp_curve.h"
#include "profiles/trapezoid.h"

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

struct TimedCurve {
  TcpCurvePtr curve;  ///< of the TCP in the robot base
  Trapezoid profile;
  const char* name;        ///< "line": for messages
  const PathSpeed* speed;  ///< as it was asked for: for messages; null: the times were
};

/// The trajectory from `start` along the curve with the pose bits of `start`; or the first point that cannot
/// be passed (path_check.h).
[[nodiscard]] Result<TrajectoryPtr, Refusal> follow(const arm::ArmModel& arm, const arm::JointVector& start,
                                                    const TimedCurve& timed, const Setting& setting);

/// The TCP in the robot base.
[[nodiscard]] arm::Pose tcpInRobotBase(const arm::ArmModel& arm, const arm::JointVector& joints,
                                       const Setting& setting);

/// The time [s] that `length` [m] and `turn` [rad] take at top speed: of the two the slower one.
[[nodiscard]] double timeAtTopSpeed(const arm::ArmModel& arm, double length, double turn,
                                    const PathSpeed& speed, double speed_override);

}  // namespace cobot_command::motion
