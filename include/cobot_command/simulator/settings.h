// How a simulated controller is set up; every default is what a TMflow project with one Listen node would
// show.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/common/units.h"
#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

/// What the project does when a motion cannot be made (fact sheet 8.9: not documented for port 5890).
enum class MotionErrorPolicy {
  ReportFalse,  ///< the error shows in the status stream, open tags are reported false, the project runs on
  StopProject   ///< the same, then the project stops: the script port closes
};

struct Settings {
  std::string listen_node_message = "Listen1";  ///< sent when the node is entered
  bool project_running = true;                  ///< at the start
  /// Posture at the start [rad]: J = 0, 0, 90, 0, 90, 0 degrees, tool downwards.
  arm::JointVector start_posture =
      (arm::JointVector() << 0.0, 0.0, degToRad(90), 0.0, degToRad(90), 0.0).finished();
  Duration status_period = std::chrono::milliseconds(15);  ///< of the status stream (fact sheet chapter 3)
  int project_speed_percent = 100;                         ///< 5..100, multiples of 5
  bool accept_empty_length = false;                        ///< see FrameDecoder::Options
  /// On at the start. (Said in full: GCC 12 crashes on the short form when Settings{} stands in a template.)
  FaultSwitches faults = FaultSwitches();
  MotionErrorPolicy on_motion_error = MotionErrorPolicy::ReportFalse;
  /// From full motion to standstill, on the path, by Pause and StopAndClearBuffer; and back by Resume.
  Duration stop_time = std::chrono::milliseconds(200);
  /// The arm goes on when the safeguard is closed again; else the project is paused then, and needs Resume().
  bool safeguard_resets_itself = true;
  /// From leaving the Listen node (ScriptExit) until the project's loop enters it again; absent: never.
  std::optional<Duration> reentry_delay = std::chrono::milliseconds(100);
  std::string project_name = "ListenProject";
  std::string tmflow_version = "1.80";  ///< one of knownTmflowVersions(): the functions of scripts
  /// What ChangeBase("name") and ChangeTCP("name") know besides RobotBase and NOTOOL: bases in the robot
  /// base, TCPs in the flange [m].
  std::map<std::string, arm::Pose> bases;
  std::map<std::string, arm::Pose> tcps;
  /// What Point["name"] knows: postures of the arm [rad].
  std::map<std::string, arm::JointVector> points;
  /// Declarations of the project's variables: "int var_i = 5". One that is none makes no variable.
  std::vector<std::string> variables;
};

[[nodiscard]] const std::vector<std::string>& knownTmflowVersions();
/// Nothing when it is the declaration of a variable.
[[nodiscard]] std::optional<std::string> whyNoVariable(const std::string& declaration);

}  // namespace cobot_command::simulator
