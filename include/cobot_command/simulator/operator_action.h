// Actions of the operator of a simulated controller, as values: keys of the pendant, switches of the cell,
// wires of the control box. Also faults of the environment, which no operator can trigger.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/simulator/fault_switches.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::simulator {

/// Opens the script port, enters the Listen node, and clears a robot error. Base and TCP are RobotBase and
/// NOTOOL again. Refused while the emergency stop is pressed.
struct RunProject {};
/// Stops the arm on its path, clears the queue, and closes the script port with its clients.
struct StopProject {};
/// As the script commands Pause() and Resume(): the arm stops on its path, scripts continue.
struct PauseProject {};
struct ResumeProject {};
/// The flow leaves the node when the queued motions are done, and stays outside until EnterListenNode.
struct LeaveListenNode {};
struct EnterListenNode {};
/// Pressed: the arm stops immediately and the project stops. Released: the arm is at standstill until the
/// project is run again.
struct SetEmergencyStop {
  bool pressed = true;
};
/// Open: the arm decelerates to standstill on its path. Closed again: see Settings::safeguard_resets_itself.
struct SetSafeguard {
  bool open = true;
};
struct SetOperatingMode {
  OperatingMode mode = OperatingMode::Automatic;
};
/// 5..100 in steps of 5. Applies to the motions that start afterwards, see Settings::project_speed_live.
struct SetProjectSpeed {
  int percent = 100;
};
[[nodiscard]] constexpr bool isProjectSpeed(int percent) {
  return percent >= 5 && percent <= 100 && percent % 5 == 0;
}
/// Robot error: the arm stops on its path and every tag in the queue is reported false, as after a motion
/// that is not possible. Every motion also fails until ClearError or RunProject.
struct RaiseError {
  int code = 0;      ///< not 0
  std::string text;  ///< Error_Content
};
struct ClearError {};
struct SetInput {
  script::IoModule module = script::IoModule::ControlBox;
  int index = 0;
  bool on = true;
};

/// Changes of the project on the pendant. In contrast to assignments by scripts they outlive the project run.
/// They take effect at the next ChangeTCP() or ChangeBase(). Numbers are in the units of the pendant; the
/// controller stores 32-bit floats. Refused: a name that the project does not have, or whose values are fixed
/// (NOTOOL, HandCamera, RobotBase); coordinates beyond arm::kMaxCoordinate.
struct SetTcp {
  std::string name;
  arm::ControllerPose value{};  ///< in the flange
};
struct SetBase {
  std::string name;
  arm::ControllerPose value{};  ///< in the robot base
};
/// Mass properties of a TCP.
struct SetLoad {
  std::string name;                                ///< of the TCP
  double mass = 0;                                 ///< [kg], 0 to kMostMass
  std::optional<std::array<double, 3>> moment;     ///< [kg mm^2], 0 to kMostMoment; std::nullopt: unchanged
  std::optional<arm::ControllerPose> mass_center;  ///< its frame in the TCP frame; std::nullopt: unchanged
};
inline constexpr double kMostMass = 1000;
inline constexpr double kMostMoment = 1e9;

/// SetFault: see fault_switches.h.
struct ClearFaults {};
/// Disconnects every client; the ports do not change.
struct DropConnections {};

using OperatorAction =
    std::variant<RunProject, StopProject, PauseProject, ResumeProject, LeaveListenNode, EnterListenNode,
                 SetEmergencyStop, SetSafeguard, SetOperatingMode, SetProjectSpeed, RaiseError, ClearError,
                 SetInput, SetTcp, SetBase, SetLoad, SetFault, ClearFaults, DropConnections>;

}  // namespace cobot_command::simulator
