// The true state of the simulated robot, in SI.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::simulator {

/// Digital inputs, or outputs; true: on.
struct DigitalIo {
  std::array<bool, script::ioCount(script::IoModule::ControlBox)> control_box{};
  std::array<bool, script::ioCount(script::IoModule::EndModule)> end_module{};

  /// Precondition: 0 <= index < ioCount(module).
  [[nodiscard]] bool& at(script::IoModule module, int index) {
    const auto place = static_cast<std::size_t>(index);
    return module == script::IoModule::ControlBox ? control_box.at(place) : end_module.at(place);
  }
  [[nodiscard]] bool at(script::IoModule module, int index) const {
    const auto place = static_cast<std::size_t>(index);
    return module == script::IoModule::ControlBox ? control_box.at(place) : end_module.at(place);
  }
};

/// As MA_Mode.
enum class OperatingMode { Automatic = 1, Manual = 2 };

struct RobotState {
  Instant time{};
  Instant started{};                                       ///< when the controller was switched on
  Instant project_started{};                               ///< undefined while no project runs
  arm::JointVector joints = arm::JointVector::Zero();      ///< [rad]
  arm::JointVector velocities = arm::JointVector::Zero();  ///< [rad/s]
  arm::Pose flange = arm::Pose::Identity();                ///< in the robot base [m]
  arm::Pose base = arm::Pose::Identity();                  ///< the active base in the robot base [m]
  arm::Pose tcp = arm::Pose::Identity();                   ///< the active TCP in the flange [m]
  std::string base_name = script::kRobotBase;              ///< empty if the base was given by value
  std::string tcp_name = script::kNoTool;                  ///< empty if the TCP was given by value
  double tcp_mass = 0;                                     ///< [kg], of the tool (ChangeTCP)
  script::ToolInertia tcp_inertia;
  double load = 0;  ///< payload [kg] (ChangeLoad)
  /// External force on the TCP [N]. Zero, because the simulation has no contacts.
  Eigen::Vector3d tcp_force = Eigen::Vector3d::Zero();
  DigitalIo inputs;
  DigitalIo outputs;
  float analog_output = 0;  ///< the first analog output of the control box [V]
  bool camera_light = false;
  bool auto_remote = false;  ///< Auto_Remote_Active
  bool in_motion = false;    ///< also false while a pause holds the arm within a motion
  bool project_running = false;
  bool project_paused = false;
  bool listening = false;
  bool emergency_stop = false;
  bool safeguard = false;  ///< open: it stops the arm
  OperatingMode mode = OperatingMode::Automatic;
  bool error = false;
  int error_code = 0;  ///< as the controller's Error_Code (TM 2.6)
  std::string error_text;
  std::optional<Instant> error_time;  ///< start of the error
  int queued_motions = 0;             ///< accepted and not ended, including the running one
  int project_speed_percent = 100;
};

}  // namespace cobot_command::simulator
