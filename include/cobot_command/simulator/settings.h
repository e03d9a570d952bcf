// How a simulated controller is set up; every default is what a TMflow project with one Listen node would
// show.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"
#include "cobot_command/protocol/item_content.h"
#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

/// What the project does when a motion cannot be made (TM 8.9: not documented for port 5890).
enum class MotionErrorPolicy {
  ReportFalse,  ///< the error shows in the status stream, open tags are reported false, the project runs on
  StopProject   ///< the same, then the project stops: the script port closes
};

/// The 47 items that the vendor's ROS driver needs (TM 3.2); then what tells tool, base and error, as
/// far as the version has it.
[[nodiscard]] std::vector<std::string> defaultStreamItems();

struct Settings {
  std::string listen_node_message = "Listen1";  ///< sent when the node is entered
  bool project_running = true;                  ///< at the start
  /// Posture at the start [rad]: J = 0, 0, 90, 0, 90, 0 degrees, tool downwards.
  arm::JointVector start_posture =
      (arm::JointVector() << 0.0, 0.0, degToRad(90), 0.0, degToRad(90), 0.0).finished();
  arm::Pose start_tcp = arm::Pose::Identity();  ///< active when the project begins, in the flange [m]
  Duration status_period = std::chrono::milliseconds(15);  ///< of the status stream (TM 3)
  protocol::ItemFormat stream_format = protocol::ItemFormat::Binary;
  /// Predefined items and global variables, in the order of the stream. Robot_Link comes first in any case.
  std::vector<std::string> stream_items = defaultStreamItems();
  /// Addresses of clients that may write items, as "192.168.1.7"; absent: all may.
  std::optional<std::set<std::string, std::less<>>> write_clients;
  int project_speed_percent = 100;   ///< 5..100, multiples of 5
  bool project_speed_live = false;   ///< a change of it counts for the motion that is under way, too
  bool accept_empty_length = false;  ///< see FrameDecoder::Options
  /// On at the start. (Said in full: GCC 12 crashes on the short form when Settings{} stands in a template.)
  FaultSwitches faults = FaultSwitches();
  MotionErrorPolicy on_motion_error = MotionErrorPolicy::ReportFalse;
  /// From full motion to standstill, on the path, by Pause and StopAndClearBuffer; and back by Resume.
  Duration stop_time = std::chrono::milliseconds(200);
  /// By which the arm follows a PVT late. It comes to the same places and the same end, with its tags.
  Duration pvt_lag{};
  /// The arm goes on when the safeguard is closed again; else the project is paused then, and needs Resume().
  bool safeguard_resets_itself = true;
  /// From leaving the Listen node (ScriptExit) until the project's loop enters it again; absent: never.
  std::optional<Duration> reentry_delay = std::chrono::milliseconds(100);
  /// The Listen node is left when nobody connects, or when no client sends anything, for so long; not above
  /// 0: never.
  Duration connection_timeout{};
  Duration data_timeout{};
  /// Does a motion fail when tool and load are more than the model carries?
  bool checks_payload = true;
  /// Is a time to top speed of 0 taken, as the shortest ramp that the arm allows? Else it is a robot error.
  bool accept_zero_ramp = true;
  /// Between which angles the safety functions let joints be, as the status port tells them, by the index of
  /// the joint; of others those of the model. The arm is not stopped by them.
  std::map<std::size_t, arm::JointLimit> safety_limits;
  /// How fast the TCP turns at 100 % on lines and circles [rad/s]. Like that of the command layer, whose
  /// plans are wrong otherwise.
  double turn_speed = arm::kUsualTurnSpeed;
  /// Standard deviations of what the status port and the attributes in scripts tell; 0: exact.
  double joint_noise = 0;         ///< [rad]
  double speed_noise = 0;         ///< [rad/s]
  double torque_noise = 0;        ///< [Nm]
  double force_noise = 0;         ///< [N]
  int noise_seed = 1;             ///< the same seed gives the same noise on every run
  bool velocity_licence = false;  ///< are there continuous velocities (ContinueVJog, ContinueVLine, …)?
  std::string project_name = "ListenProject";
  std::string tmflow_version = "1.80";  ///< decides which functions scripts have, and which items there are
  /// What ChangeBase("name") and ChangeTCP("name") know besides RobotBase and NOTOOL: bases in the robot
  /// base, TCPs in the flange [m].
  std::map<std::string, arm::Pose> bases;
  std::map<std::string, arm::Pose> tcps;
  /// What Point["name"] knows: postures of the arm [rad].
  std::map<std::string, arm::JointVector> points;
  /// Declarations of variables that scripts share: "int var_i = 5". Those whose name begins with g_ are
  /// global: they keep their values from one run of the project to the next. On the status port there are
  /// only those that are in the stream.
  std::vector<std::string> variables;
};

/// What `tmflow_version` can be.
[[nodiscard]] const std::vector<std::string>& knownTmflowVersions();

/// A row for each setting, in the order of the pages; `settings` outlives it.
[[nodiscard]] SettingTable settingsTable(Settings& settings);

/// What does not fit together: version, variables, items of the stream; then postures and `arm`. The
/// controller leaves out what is wrong.
[[nodiscard]] std::optional<SettingFault> faultIn(const Settings& settings);
[[nodiscard]] std::optional<SettingFault> faultIn(const Settings& settings, const arm::ArmModel& arm);

}  // namespace cobot_command::simulator
