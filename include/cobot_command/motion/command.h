// What can be asked of an arm: point-to-point, line and circle, to a place or by an offset, lines through
// many points, and points with their speeds and times; as plain values in SI.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

namespace cobot_command::motion {

/// A target pose of the TCP in the active base. Without bits the posture keeps the bits of the start (FB
/// section 4.3.1).
struct PoseTarget {
  arm::Pose pose;
  std::optional<arm::PoseBits> bits;
};

/// A move in joint space, all joints starting and ending together.
struct Ptp {
  std::variant<arm::JointVector, PoseTarget> target;
  double speed_ratio = 1.0;      ///< (0, 1] of the rated joint speeds
  Duration time_to_top_speed{};  ///< here and below: zero for the shortest that the arm allows
};

/// The highest speed of a TCP that a script can ask for [m/s] (thesis table 5.3.2.3).
inline constexpr double kMaxTcpSpeed = 4.5;

/// Speed of a TCP along its path: as a ratio (0, 1] of the model's typical maximum, or in m/s.
struct SpeedRatio {
  double value = 1.0;
};
struct TcpSpeed {
  double metres_per_second = 0.0;
};
using PathSpeed = std::variant<SpeedRatio, TcpSpeed>;

/// A straight line of the TCP; the orientation turns about one axis, in step with the distance.
struct Line {
  arm::Pose target;  ///< TCP in the active base
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// An arc of the TCP from the start through `via` to `end` (thesis 4.3.3).
struct Circle {
  arm::Pose via;  ///< TCP in the active base; its orientation is not used
  arm::Pose end;  ///< TCP in the active base
  /// Absent: to `end`, the orientation turning towards it. Present: this angle [rad, not 0] along the circle
  /// through the three points, the orientation held.
  std::optional<double> arc_angle;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A displacement of the TCP from where the motion starts.
struct PoseOffset {
  enum class Axes {
    Base,  ///< shifted along the axes of the active base, turned about axes parallel to them: R = R(by)
           ///< R(start)
    Tool   ///< in the tool: start * by
  };
  arm::Pose by = arm::Pose::Identity();
  Axes axes = Axes::Base;
};

/// A PTP by an offset: of each joint [rad], or of the TCP with the pose bits of the start.
struct MovePtp {
  std::variant<arm::JointVector, PoseOffset> offset;
  double speed_ratio = 1.0;  ///< (0, 1] of the rated joint speeds
  Duration time_to_top_speed{};
};

/// A line by an offset of the TCP.
struct MoveLine {
  PoseOffset offset;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A straight line of the TCP to where `target` puts it, one of a chain: with a blend the TCP passes on into
/// the next one at its speed (blend.h).
struct PLine {
  std::variant<arm::JointVector, arm::Pose> target;  ///< [rad]; or the TCP in the active base
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// A PLine by an offset: of each joint [rad], or of the TCP.
struct MovePLine {
  std::variant<arm::JointVector, PoseOffset> offset;
  PathSpeed speed;
  Duration time_to_top_speed{};
};

/// Of a TCP, along and about the axes of the active base.
struct TcpVelocity {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Points that are passed at given velocities and times: cubics between them, from rest to rest.
struct PvtJointPoint {
  arm::JointVector position;  ///< [rad]
  arm::JointVector velocity;  ///< [rad/s]
  double duration = 0.0;      ///< from the point before [s]
};
struct PvtPosePoint {
  arm::Pose pose;  ///< TCP in the active base
  TcpVelocity velocity;
  double duration = 0.0;
};
/// The least time between two points of a PVT that is made of a motion: ramps, cruises and overlaps that are
/// meant for one are not shorter.
inline constexpr Duration kLeastSegment = std::chrono::milliseconds(25);
struct Pvt {
  std::variant<std::vector<PvtJointPoint>, std::vector<PvtPosePoint>> points;
};

/// The law by which the speed grows on a ramp whose acceleration varies all the time; see doc/motion.md.
enum class SpeedLaw { SCurve, Poly5, ModSine, SineSquared };

/// What share (0..1) of the time of each ramp the acceleration varies, by the law; 0: it jumps, a trapezoid.
struct RampShape {
  SpeedLaw law = SpeedLaw::SCurve;
  double up = 0.0;
  double down = 0.0;
};

/// Highest speed, acceleration and deceleration of one thing that moves; all above 0.
struct Rates {
  double speed = 0.0;         ///< [1/s] of its unit, rad or m
  double acceleration = 0.0;  ///< [1/s^2]
  double deceleration = 0.0;  ///< [1/s^2]
};

/// A move in joint space as a Ptp, with rates and ramps of its own.
struct JointMove {
  arm::JointVector target;
  Rates rates;  ///< of the joint with the longest way [rad]; all others in step with it
  RampShape ramps;
};

/// Of a TCP on its path: of the way [m] and of its turn [rad], of which the slower one rules.
struct PathRates {
  Rates way;
  Rates turn;
  RampShape ramps;
};

/// A straight line as a Line, with rates and ramps of its own.
struct StraightMove {
  arm::Pose target;  ///< TCP in the active base
  PathRates rates;
};

/// An arc as a Circle without an angle, with rates and ramps of its own.
struct ArcMove {
  arm::Pose via;
  arm::Pose target;  ///< TCP in the active base
  PathRates rates;
};

/// A straight line of the TCP's place, J4..J6 in step with it: the wrist may pass through J5 = 0, and turn
/// more than once.
struct WristMove {
  arm::JointVector target;
  PathRates rates;  ///< turn: of that of J4..J6 with the longest way
};

using Command = std::variant<Ptp, Line, Circle, MovePtp, MoveLine, PLine, MovePLine, Pvt, JointMove,
                             StraightMove, ArcMove, WristMove>;

/// What the controller knows when it plans a motion.
struct Setting {
  arm::Pose base = arm::Pose::Identity();  ///< the active base in the robot base
  arm::Pose tcp = arm::Pose::Identity();   ///< the active TCP in the flange
  double speed_override = 1.0;             ///< project speed, (0, 1]
  /// How far the arm may be turned from `start` [rad, 0..pi/2]. A motion to a pose whose way depends on it is
  /// refused as AmbiguousTurn; 0: this is the arm itself, which takes one of both ways.
  double start_tolerance = 0.0;
};

}  // namespace cobot_command::motion
