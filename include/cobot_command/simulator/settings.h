// Settings of a simulated controller. The defaults correspond to a TMflow project with one Listen node.
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

/// Reaction of the project to a motion that is not possible (TM 8.9: not documented for port 5890).
enum class MotionErrorPolicy {
  ReportFalse,  ///< the status stream shows the error, open tags are reported false, the project continues
  StopProject   ///< the same, then the project stops: the script port closes
};

/// The 47 items that the vendor's ROS driver needs (TM 3.2), and the items for tool, base and error that the
/// version has.
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
  /// Predefined items and global variables, in the order of the stream. Robot_Link is always first.
  std::vector<std::string> stream_items = defaultStreamItems();
  /// Addresses of clients that may write items, as "192.168.1.7"; absent: all clients may write.
  std::optional<std::set<std::string, std::less<>>> write_clients;
  int project_speed_percent = 100;   ///< 5..100, multiples of 5
  bool project_speed_live = false;   ///< a change also applies to the running motion
  bool accept_empty_length = false;  ///< see FrameDecoder::Options
  /// Active at the start. (Written in full because GCC 12 crashes on the short form if Settings{} is in a
  /// template.)
  FaultSwitches faults = FaultSwitches();
  MotionErrorPolicy on_motion_error = MotionErrorPolicy::ReportFalse;
  /// From full speed to standstill, on the path, for Pause and StopAndClearBuffer; and back for Resume.
  Duration stop_time = std::chrono::milliseconds(200);
  /// Delay of the arm on a PVT. It reaches the same positions and the same end, with its tags.
  Duration pvt_lag{};
  /// True: the arm continues when the safeguard is closed again. False: the project is then paused and needs
  /// Resume().
  bool safeguard_resets_itself = true;
  /// From leaving the Listen node (ScriptExit) until the loop of the project enters it again; absent: never.
  std::optional<Duration> reentry_delay = std::chrono::milliseconds(100);
  /// The Listen node is left if no client connects, or if no client sends anything, for this time; not above
  /// 0: never.
  Duration connection_timeout{};
  Duration data_timeout{};
  /// True: a motion fails if tool and load exceed the payload of the model.
  bool checks_payload = true;
  /// True: a time to top speed of 0 means the shortest ramp that the arm allows. False: it is a robot error.
  bool accept_zero_ramp = true;
  /// Joint ranges of the safety functions, as reported on the status port, by joint index. Joints that are
  /// not listed have the range of the model. The arm is not stopped by them.
  std::map<std::size_t, arm::JointLimit> safety_limits;
  /// Angular speed of the TCP at 100 % on lines and circles [rad/s]. It must be the same as in the command
  /// layer; otherwise the plans of the command layer are wrong.
  double turn_speed = arm::kUsualTurnSpeed;
  /// Standard deviations of the values on the status port and of the attributes in scripts; 0: exact.
  double joint_noise = 0;         ///< [rad]
  double speed_noise = 0;         ///< [rad/s]
  double torque_noise = 0;        ///< [Nm]
  double force_noise = 0;         ///< [N]
  int noise_seed = 1;             ///< the same seed gives the same noise in every run
  bool velocity_licence = false;  ///< enables continuous velocities (ContinueVJog, ContinueVLine, …)
  std::string project_name = "ListenProject";
  std::string tmflow_version = "1.80";  ///< determines the script functions and the status items
  /// Bases and TCPs for ChangeBase("name") and ChangeTCP("name"), in addition to RobotBase, NOTOOL and
  /// HandCamera: bases in the robot base, TCPs in the flange [m].
  std::map<std::string, arm::Pose> bases;
  std::map<std::string, arm::Pose> tcps;
  /// Points for Point["name"]: postures of the arm [rad].
  std::map<std::string, arm::JointVector> points;
  /// Declarations of variables that scripts share: "int var_i = 5". Variables whose name starts with g_ are
  /// global: they keep their values from one project run to the next. The status port only has those that are
  /// in the stream.
  std::vector<std::string> variables;
};

/// Valid values of `tmflow_version`.
[[nodiscard]] const std::vector<std::string>& knownTmflowVersions();

/// One row per setting, in the order of the pages. `settings` must outlive it.
[[nodiscard]] SettingTable settingsTable(Settings& settings);

/// Inconsistent settings: version, variables, items of the stream; then postures and `arm`. The controller
/// ignores invalid entries.
[[nodiscard]] std::optional<SettingFault> faultIn(const Settings& settings);
[[nodiscard]] std::optional<SettingFault> faultIn(const Settings& settings, const arm::ArmModel& arm);

}  // namespace cobot_command::simulator
