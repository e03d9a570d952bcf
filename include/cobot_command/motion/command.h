// The motion commands for an arm, as plain values in SI: point-to-point, line and circle, absolute or
// relative; chained lines through many points; points with velocities and times.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

namespace cobot_command::motion {

/// A target pose of the TCP in the active base. Without bits the bits of the start are kept (FB section
/// 4.3.1).
struct PoseTarget {
  arm::Pose pose;
  std::optional<arm::PoseBits> bits;
};

/// A move in joint space; all joints start and end together.
struct Ptp {
  std::variant<arm::JointVector, PoseTarget> target;
  double speed_ratio = 1.0;      ///< (0, 1] of the rated joint speeds
  Duration time_to_top_speed{};  ///< here and below: zero means the shortest time that the arm allows
};

/// The highest TCP speed that a script can request [m/s] (thesis table 5.3.2.3).
inline constexpr double kMaxTcpSpeed = 4.5;

/// Speed of the TCP along its path: as a ratio (0, 1] of the typical maximum of the model, or in m/s.
struct SpeedRatio {
  double value = 1.0;
};
struct TcpSpeed {
  double metres_per_second = 0.0;
};
using PathSpeed = std::variant<SpeedRatio, TcpSpeed>;

/// A straight line of the TCP. The orientation turns about one axis, synchronously with the distance.
struct Line {
  arm::Pose target;  ///< TCP in the active base
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// An arc of the TCP from the start through `via` to `end` (thesis 4.3.3).
struct Circle {
  arm::Pose via;  ///< TCP in the active base; its orientation is not used
  arm::Pose end;  ///< TCP in the active base
  /// Absent: to `end`, and the orientation turns to that of `end`. Present: by this angle [rad, not 0] along
  /// the circle through the three points, with constant orientation.
  std::optional<double> arc_angle;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A displacement of the TCP relative to the start of the motion.
struct PoseOffset {
  enum class Axes {
    Base,  ///< translation along the axes of the active base, rotation about axes parallel to them: R = R(by)
           ///< R(start)
    Tool   ///< in the tool: start * by
  };
  arm::Pose by = arm::Pose::Identity();
  Axes axes = Axes::Base;
};

/// A relative PTP: an offset of each joint [rad], or of the TCP with the pose bits of the start.
struct MovePtp {
  std::variant<arm::JointVector, PoseOffset> offset;
  double speed_ratio = 1.0;  ///< (0, 1] of the rated joint speeds
  Duration time_to_top_speed{};
};

/// A relative line: an offset of the TCP.
struct MoveLine {
  PoseOffset offset;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A straight line of the TCP to the TCP pose of `target`, one of a chain: with a blend the TCP continues
/// into the next line at its speed (blend.h).
struct PLine {
  std::variant<arm::JointVector, arm::Pose> target;  ///< [rad]; or the TCP in the active base
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A relative PLine: an offset of each joint [rad], or of the TCP.
struct MovePLine {
  std::variant<arm::JointVector, PoseOffset> offset;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// Velocity of the TCP along and about the axes of the active base.
struct TcpVelocity {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Points with velocities and times, connected by cubics, from rest to rest.
struct PvtJointPoint {
  arm::JointVector position;  ///< [rad]
  arm::JointVector velocity;  ///< [rad/s]
  double duration = 0.0;      ///< since the previous point [s]
};
struct PvtPosePoint {
  arm::Pose pose;  ///< TCP in the active base
  TcpVelocity velocity;
  double duration = 0.0;
};
/// The shortest time between two points of a PVT that is generated from a motion. Ramps, cruises and overlaps
/// that are meant for one are not shorter.
inline constexpr Duration kLeastSegment = std::chrono::milliseconds(25);
struct Pvt {
  std::variant<std::vector<PvtJointPoint>, std::vector<PvtPosePoint>> points;
};

/// The speed profile of a ramp with continuously varying acceleration; see doc/motion.md.
enum class SpeedLaw { SCurve, Poly5, ModSine, SineSquared };

/// The share (0..1) of each ramp's time in which the acceleration varies according to the law; 0: a
/// trapezoid, the acceleration jumps.
struct RampShape {
  SpeedLaw law = SpeedLaw::SCurve;
  double up = 0.0;
  double down = 0.0;
};

/// Highest speed, acceleration and deceleration of one moving quantity; all above 0.
struct Rates {
  double speed = 0.0;         ///< [1/s] in its unit, rad or m
  double acceleration = 0.0;  ///< [1/s^2]
  double deceleration = 0.0;  ///< [1/s^2]
};

/// A move in joint space as a Ptp, with its own rates and ramps.
struct JointMove {
  arm::JointVector target;
  Rates rates;  ///< of the joint with the longest path [rad]; the others are synchronised with it
  RampShape ramps;
};

/// Rates of a TCP on its path: distance [m] and rotation [rad]. The slower of the two determines the motion.
struct PathRates {
  Rates way;
  Rates turn;
  RampShape ramps;
};

/// A straight line as a Line, with its own rates and ramps.
struct StraightMove {
  arm::Pose target;  ///< TCP in the active base
  PathRates rates;
};

/// An arc as a Circle without an angle, with its own rates and ramps.
struct ArcMove {
  arm::Pose via;
  arm::Pose target;  ///< TCP in the active base
  PathRates rates;
};

/// A straight line of the TCP position, with J4..J6 interpolated synchronously. The wrist may pass through J5
/// = 0 and turn more than once.
struct WristMove {
  arm::JointVector target;
  PathRates rates;  ///< turn: of the joint of J4..J6 with the longest path
};

using Command = std::variant<Ptp, Line, Circle, MovePtp, MoveLine, PLine, MovePLine, Pvt, JointMove,
                             StraightMove, ArcMove, WristMove>;

/// The controller settings that a motion is planned with.
struct Setting {
  arm::Pose base = arm::Pose::Identity();  ///< the active base in the robot base
  arm::Pose tcp = arm::Pose::Identity();   ///< the active TCP in the flange
  double speed_override = 1.0;             ///< project speed, (0, 1]
  /// Largest rotation of the arm from `start` that the plan must tolerate [rad, 0..pi/2]. A motion to a pose
  /// is refused as AmbiguousTurn if its direction depends on this rotation. 0: `start` is exact, as in the
  /// arm itself, and one of both directions is taken.
  double start_tolerance = 0.0;
};

}  // namespace cobot_command::motion
