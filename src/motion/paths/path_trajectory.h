// The joints that follow a TCP curve in time, checked wholly before the start.
#pragma once

#include "curves/tcp_curve.h"
#include "paths/path_check.h"
#include "profiles/profile.h"

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// For messages.
struct TimedWords {
  const char* name;  ///< "line"
  AskedSpeed speed;
  arm::Pose base;  ///< the active one in the robot base
};

struct TimedCurve {
  TcpCurvePtr curve;  ///< of the TCP in the robot base
  ProfilePtr profile;
  const char* name;  ///< "line": for messages
  AskedSpeed speed;
};

/// The trajectory from `start` along the curve with the pose bits of `start`; or the first point that cannot
/// be passed (path_check.h).
[[nodiscard]] Result<TrajectoryPtr, Refusal> follow(const arm::ArmModel& arm, const arm::JointVector& start,
                                                    const TimedCurve& timed, const Setting& setting);

/// The same with postures of any kind, in as much time as `profile` has.
[[nodiscard]] Result<TrajectoryPtr, Refusal> follow(const PathPosturesPtr& postures,
                                                    const arm::JointVector& start, const ProfilePtr& profile,
                                                    const TimedWords& words);

/// The TCP in the robot base.
[[nodiscard]] arm::Pose tcpInRobotBase(const arm::ArmModel& arm, const arm::JointVector& joints,
                                       const Setting& setting);

/// For messages: a speed in mm/s is at most the one that the TCP has in `time_at_top_speed` [s].
[[nodiscard]] AskedSpeed askedSpeed(const PathSpeed& speed, double length, double time_at_top_speed);

/// The time [s] that `length` [m] and `turn` [rad] take at top speed: of the two the slower one.
[[nodiscard]] double timeAtTopSpeed(const arm::ArmModel& arm, double length, double turn,
                                    const PathSpeed& speed, double speed_override);

/// What that top speed is of the one at 100 %: above 1 where a speed in mm/s is; 1 of no way.
[[nodiscard]] double shareOfFullSpeed(const arm::ArmModel& arm, double length, double turn,
                                      const PathSpeed& speed);

}  // namespace cobot_command::motion
