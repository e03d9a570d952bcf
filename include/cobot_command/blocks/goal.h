// What a user asks of the function blocks. Field names, units and ranges: the thesis's tables (spec:
// function-blocks).
//
// Enumerations are integers as they come from outside: any value may arrive, and the checks name the wrong
// ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/arm/types.h"

namespace cobot_command::blocks {

/// Chosen by the caller, unique for the life of a core.
using GoalId = std::uint64_t;

/// x y z [mm] rx ry rz [deg], or J1..J6 [deg], as the data format says.
using SixValues = std::array<double, 6>;

/// What becomes of a goal that comes while another command is Busy.
enum class BufferMode : int {
  Refuse = 0,    ///< 16#11, as in the thesis
  Buffered = 1,  ///< waits its turn behind all others
  Aborting = 2   ///< stops the robot, ends all others as CommandAborted, then runs
};

/// A pose in any frame, in place of the numbers of a function block; as it came from outside.
struct FramedPose {
  std::string frame;                   ///< as the caller named it
  std::array<double, 3> position{};    ///< [m]
  std::array<double, 4> quaternion{};  ///< x y z w, of unit length
  /// The frame in the robot base; absent when it could not be found, and then `fault` says why.
  std::optional<arm::Pose> frame_in_robot_base;
  std::string fault;
  /// Meant is where the frame is, and not where it was at some time: a goal that has waited is refused when
  /// it has moved.
  bool latest = false;
};

/// CBT_Connect (thesis 5.3.1): open the link and supervise it. Busy while connected.
struct ConnectGoal {
  std::string host;                ///< name or address of the controller
  int port = 5890;                 ///< script port, 0..65535; 0 is refused as nothing can listen there
  double timeout = 10;             ///< how long to try [s], 10..300
  std::optional<int> status_port;  ///< of the status stream, 0: none; absent: the port of LinkSettings
};

enum class Movement : int { Line = 0, Ptp = 1 };                                  ///< Table 5.3.2.4
enum class AbsoluteFormat : int { Jpp = 0, Cpp = 1, Cpr = 2, Cap = 3, Car = 4 };  ///< Table 5.3.2.5
/// Table 5.3.3.5
enum class RelativeFormat : int {
  Jpp = 0,
  Cpp = 1,
  Cpr = 2,
  Cap = 3,
  Car = 4,
  Tpp = 5,
  Tpr = 6,
  Tap = 7,
  Tar = 8
};
enum class CircleFormat : int { Cpp = 0, Cap = 1 };         ///< Table 5.3.4.4
enum class ProgramCommand : int { Pause = 0, Resume = 1 };  ///< Table 5.3.7.4

/// CBT_MoveAbsolute (thesis 5.3.2).
struct MoveAbsoluteGoal {
  int command_id = 0;        ///< 0: the layer picks a tag; 2..9 as in the thesis
  int movement_command = 1;  ///< Movement
  int data_format = 1;       ///< AbsoluteFormat
  SixValues target{};
  std::optional<FramedPose> target_pose;  ///< in place of `target`, with a Cartesian format
  double speed = 0;                       ///< % (0, 100] or mm/s (0, 4500], as the format says
  double accel_time = 0;                  ///< time to top speed [ms], 150..9999
  bool blending_enable = false;
  double blending_value = 0;                 ///< % 0..100, or mm 0..2000 with a radius format
  bool disable_precise_positioning = false;  ///< the controller's own sense: false is precise
  bool robot_pose_enable = false;
  std::array<int, 3> robot_pose{0, 2, 4};  ///< Config1..3
  bool exit_node = false;                  ///< leave the Listen node after the motion
  int buffer_mode = 0;                     ///< BufferMode
  bool check_only = false;                 ///< validate and plan; nothing is sent
};

/// CBT_MoveRelative (thesis 5.3.3): from where the robot then is.
struct MoveRelativeGoal {
  int command_id = 0;
  int movement_command = 1;  ///< Movement
  int data_format = 1;       ///< RelativeFormat: joints, along the active base (C..) or the tool (T..)
  SixValues target{};        ///< the offset
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;
  bool disable_precise_positioning = false;  ///< the controller's own sense: false is precise
  bool exit_node = false;
  int buffer_mode = 0;
  bool check_only = false;
};

/// CBT_MoveCircle (thesis 5.3.4): an arc from where the robot is, through the arc point, to the end point.
struct MoveCircleGoal {
  int command_id = 0;
  int data_format = 0;  ///< CircleFormat
  SixValues arc_point{};
  SixValues end_point{};
  std::optional<FramedPose> arc_pose;  ///< in place of arc_point
  std::optional<FramedPose> end_pose;  ///< in place of end_point
  double speed = 0;
  double accel_time = 0;
  bool blending_enable = false;
  double blending_value = 0;  ///< % 0..100: both formats blend in %
  /// Length of the arc [deg], 0..360. 0: to the end point, turning to its orientation; else this far along
  /// the circle, the orientation held.
  double arc_angle = 0;
  bool disable_precise_positioning = false;  ///< the controller's own sense: false is precise
  bool exit_node = false;
  int buffer_mode = 0;
  bool check_only = false;
};

/// CBT_ChangeBase (thesis 5.3.5): the base of the motions behind it.
struct ChangeBaseGoal {
  int command_id = 0;                   ///< 0 or 2..9; only echoed
  SixValues transformation{};           ///< of the base in the robot base
  std::optional<FramedPose> base_pose;  ///< in place of it
  std::string base_name;                ///< in place of both: a base of the project; empty: none
  bool exit_node = false;
  int buffer_mode = 0;
};

/// CBT_ChangeTCP (thesis 5.3.6): the TCP, weight and inertia of the tool for the motions behind it.
struct ChangeTcpGoal {
  int command_id = 0;                         ///< 0 or 2..9; only echoed
  SixValues tcp_offset{};                     ///< of the TCP in the flange
  double weight = 0;                          ///< [kg], 0..14
  std::array<double, 3> moment_of_inertia{};  ///< Ixx, Iyy, Izz [kg mm^2], not negative
  SixValues mass_center{};                    ///< frame of the mass centre in the tool (the TCP's frame)
  std::string tcp_name;                       ///< in place of all that: a TCP of the project; empty: none
  bool exit_node = false;
  int buffer_mode = 0;
};

/// CBT_ProgramControl (thesis 5.3.7). Never waits behind a command and never refuses because of one.
struct ProgramControlGoal {
  int command_id = 0;  ///< 0 or 2..9; only echoed
  int command = 0;     ///< ProgramCommand
};

/// Stops the robot and empties its queue (StopAndClearBuffer), on a path of its own: never waits behind a
/// command. Everything that is Busy or waits ends as CommandAborted. Done when the robot stands.
struct StopGoal {};

/// Leaves the Listen node (ScriptExit) once all that was sent before is done.
struct ExitListenNodeGoal {
  int buffer_mode = 0;
};

/// The escape hatch: lines of script as they are. Queue tags stay the layer's business.
struct RunScriptGoal {
  std::string script;         ///< lines separated by CR LF or LF; printable, at most 4096 bytes, no QueueTag
  bool await_motion = false;  ///< Done when all its motions are; else when the controller accepted it
  double reply_timeout = 0;  ///< for the OK, longer for lines that wait [s], 0.05..3600; 0: as for all others
  int buffer_mode = 0;
};

/// A step of a sequence to be checked.
using SequenceStep =
    std::variant<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal, ChangeTcpGoal>;

/// Plans a whole list end to end: reach, pose bits, limits along every path, singularities, blends. Sends
/// nothing.
struct CheckSequenceGoal {
  std::vector<SequenceStep> steps;   ///< 1..200
  std::string steps_fault;           ///< why the steps could not be read; empty: they could
  std::vector<double> start_joints;  ///< [deg], six; empty: where the robot is, or what is sent will leave it
  int faulty_step = -1;              ///< the one that steps_fault is about, from 0; -1: none
  bool comes_round = false;          ///< behind the last step comes the first again, as in a cycle
};

/// A digital output of the controller.
struct OutputAction {
  std::string module;  ///< "EndModule" or "ControlBox"
  int output = 0;      ///< 0..3 of the EndModule, 0..15 of the ControlBox
  bool value = false;
};

/// One move of a pick-and-place cycle, and what follows once the robot stands at its target.
struct PickAndPlaceStep {
  MoveAbsoluteGoal move;
  std::optional<OutputAction> output;  ///< set first, e.g. the gripper
  double dwell = 0;                    ///< then wait [s], 0..3600
};

/// Annex B and chapter 6.3.8: above pick, pick, up, dwell, above place, place, up, dwell; again and again.
/// Checked as a whole before the first move. A pause of the robot holds the dwells too.
struct PickAndPlaceGoal {
  std::vector<PickAndPlaceStep> steps;  ///< 1..50; six in the thesis
  std::string steps_fault;              ///< why the steps could not be read; empty: they could
  int cycles = 1;                       ///< 1..1000000; 0: until cancelled
  int buffer_mode = 0;
  bool check_only = false;
};

using Goal = std::variant<ConnectGoal, MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal,
                          ChangeTcpGoal, ProgramControlGoal, StopGoal, ExitListenNodeGoal, RunScriptGoal,
                          CheckSequenceGoal, PickAndPlaceGoal>;

}  // namespace cobot_command::blocks
