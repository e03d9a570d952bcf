// What the operator of a simulated controller can do, as values: keys of the pendant, switches of the cell,
// wires of the control box; and the faults of the world, which no operator has at hand.
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

/// Opens the script port, enters the Listen node, clears a robot error; base and TCP are RobotBase and NOTOOL
/// again. Refused while the emergency stop is pressed.
struct RunProject {};
/// Stops the arm on its path, empties the queue, closes the script port and its clients.
struct StopProject {};
/// As the script command Pause(), and Resume(): the arm stands on its path, scripts go on.
struct PauseProject {};
struct ResumeProject {};
/// The flow goes to another node once the queued motions are done, and stays there until it is let back in.
struct LeaveListenNode {};
struct EnterListenNode {};
/// Pressed: the arm stands at once and the project stops. Released: stands until the project is run again.
struct SetEmergencyStop {
  bool pressed = true;
};
/// Open: the arm slows down on its path and stands. Closed again: see Settings::safeguard_resets_itself.
struct SetSafeguard {
  bool open = true;
};
struct SetOperatingMode {
  OperatingMode mode = OperatingMode::Automatic;
};
/// 5..100 in steps of 5; counts for the motions that start from then on, see Settings::project_speed_live.
struct SetProjectSpeed {
  int percent = 100;
};
[[nodiscard]] constexpr bool isProjectSpeed(int percent) {
  return percent >= 5 && percent <= 100 && percent % 5 == 0;
}
/// The robot fails: the arm comes to rest on its path and every tag in the queue is reported false, as when a
/// motion cannot be made; so is every motion until ClearError or RunProject.
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

/// What the pendant changes in the project. It outlives the run of the project, unlike what a script assigns,
/// and counts from the next ChangeTCP() or ChangeBase(). Numbers as the pendant has them; the controller
/// keeps them as 32-bit floats. Refused: a name that the project does not have, or whose values are fixed
/// (NOTOOL, HandCamera, RobotBase); coordinates beyond arm::kMaxCoordinate.
struct SetTcp {
  std::string name;
  arm::ControllerPose value{};  ///< in the flange
};
struct SetBase {
  std::string name;
  arm::ControllerPose value{};  ///< in the robot base
};
/// What a TCP weighs.
struct SetLoad {
  std::string name;                                ///< of the TCP
  double mass = 0;                                 ///< [kg], 0 to kMostMass
  std::optional<std::array<double, 3>> moment;     ///< [kg mm^2], 0 to kMostMoment; nothing: as it was
  std::optional<arm::ControllerPose> mass_center;  ///< its frame in that of the TCP; nothing: as it was
};
inline constexpr double kMostMass = 1000;
inline constexpr double kMostMoment = 1e9;

/// SetFault: see fault_switches.h.
struct ClearFaults {};
/// Drops every client; the ports stay as they are.
struct DropConnections {};

using OperatorAction =
    std::variant<RunProject, StopProject, PauseProject, ResumeProject, LeaveListenNode, EnterListenNode,
                 SetEmergencyStop, SetSafeguard, SetOperatingMode, SetProjectSpeed, RaiseError, ClearError,
                 SetInput, SetTcp, SetBase, SetLoad, SetFault, ClearFaults, DropConnections>;

}  // namespace cobot_command::simulator
