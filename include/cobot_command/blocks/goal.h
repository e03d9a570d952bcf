// What a user asks of the function blocks. Field names, units and ranges: the thesis's tables (spec:
// function-blocks).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace cobot_command::blocks {

/// Chosen by the caller, unique for the life of a core.
using GoalId = std::uint64_t;

/// CBT_Connect (thesis 5.3.1): open the link and supervise it. Busy while connected.
struct ConnectGoal {
  std::string host;                ///< name or address of the controller
  int port = 5890;                 ///< script port, 0..65535; 0 is refused as nothing can listen there
  double timeout = 10;             ///< how long to try [s], 10..300
  std::optional<int> status_port;  ///< of the status stream, 0: none; absent: the port of LinkSettings
};

enum class Movement : int { Line = 0, Ptp = 1 };                                  ///< Table 5.3.2.4
enum class AbsoluteFormat : int { Jpp = 0, Cpp = 1, Cpr = 2, Cap = 3, Car = 4 };  ///< Table 5.3.2.5

/// CBT_MoveAbsolute (thesis 5.3.2). Enumerations are integers as they come from outside: any value may
/// arrive.
struct MoveAbsoluteGoal {
  int command_id = 0;              ///< 0: the layer picks a tag; 2..9 as in the thesis
  int movement_command = 1;        ///< Movement
  int data_format = 1;             ///< AbsoluteFormat
  std::array<double, 6> target{};  ///< x y z [mm] rx ry rz [deg], or J1..J6 [deg] with JPP
  double speed = 0;                ///< % (0, 100] or mm/s (0, 4500], as the format says
  double accel_time = 0;           ///< time to top speed [ms], 150..9999
  bool blending_enable = false;
  double blending_value = 0;  ///< % 0..100, or mm 0..2000 with a radius format
  bool precise_positioning = true;
  bool robot_pose_enable = false;
  std::array<int, 3> robot_pose{0, 2, 4};  ///< Config1..3
  bool exit_node = false;                  ///< leave the Listen node after the motion
};

using Goal = std::variant<ConnectGoal, MoveAbsoluteGoal>;

}  // namespace cobot_command::blocks
