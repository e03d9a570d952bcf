#include "status_port/item_rows.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "robot/controller_clock.h"
#include "robot/sensors.h"

#include "cobot_command/script/script_command.h"

namespace cobot_command::simulator {

namespace {

using protocol::ItemValue;
using script::IoModule;
using Byte = std::uint8_t;
using Bytes = std::vector<Byte>;
using V = ItemValues;
using N = std::size_t;
using Written = std::optional<ItemWrite>;

constexpr int k180 = 180, k184 = 184;
constexpr std::size_t kLongestProjectName = 128;  // bytes; ours

// What the simulation has no quantity for: limits of the safety functions, touch stops, analog inputs.
ItemValue falseBool(const V&, N) {
  return false;
}
ItemValue zeroByte(const V&, N) {
  return Byte{0};
}
ItemValue zeroInt(const V&, N) {
  return std::int32_t{0};
}
ItemValue zeroFloat(const V&, N) {
  return 0.0F;
}
template <std::size_t Size>
ItemValue zeroFloats(const V&, N) {
  return Floats(Size, 0.0F);
}
ItemValue zeroBytes(const V&, N) {
  return Bytes(128, 0);
}

// What does not change: a controller at work in a warm room, and nothing at its outputs. Ours.
constexpr float kJointTemperature = 35.0F, kControllerTemperature = 40.0F;  // [deg C]
constexpr double kArmVoltage = 48.0, kIdleCurrent = 1.0;                    // [V], [A]
constexpr double kMilli = 1e3;

template <arm::JointVector TorqueWindow::*Which>
ItemValue torques(const V& v, N) {
  return floats(torqueWindow(v.state, v.source.arm, v.source.settings).*Which, kMilli);
}
double armCurrent(const V& v) {
  return kIdleCurrent + jointCurrents(v.state, v.source.arm, v.source.settings).cwiseAbs().sum();
}

template <IoModule Module>
ItemValue output(const V& v, N number) {
  return Byte{v.state.outputs.at(Module, static_cast<int>(number))};
}
template <IoModule Module>
ItemValue input(const V& v, N number) {
  return Byte{v.state.inputs.at(Module, static_cast<int>(number))};
}

std::optional<bool> bit(const ItemValue& value) {
  const Byte byte = std::get<Byte>(value);
  if (byte > 1) return std::nullopt;
  return byte == 1;
}

template <IoModule Module>
Written writeOutput(const ItemValue& value, N number) {
  const auto on = bit(value);
  if (!on) return std::nullopt;
  return script::WriteOutput{Module, static_cast<int>(number), *on};
}
Written writeLight(const ItemValue& value, N) {
  const auto on = bit(value);
  if (!on) return std::nullopt;
  return SetCameraLight{*on};
}
Written writeAnalog(const ItemValue& value, N) {
  const script::WriteAnalogOutput output{std::get<float>(value)};
  return std::abs(output.volt) <= script::kMostVolt ? Written(output) : std::nullopt;
}
Written writeSpeed(const ItemValue& value, N) {
  const SetProjectSpeed speed{std::get<std::int32_t>(value)};
  return isProjectSpeed(speed.percent) ? Written(speed) : std::nullopt;
}
Written writeName(const ItemValue& value, N) {
  const auto& name = std::get<std::string>(value);
  if (name.empty() || name.size() > kLongestProjectName) return std::nullopt;
  return SetProjectName{name};
}
Written writeAutoRemote(const ItemValue& value, N) {
  return SetAutoRemote{std::get<bool>(value)};
}
template <Button Which>
Written press(const ItemValue& value, N) {
  return PressButton{Which, std::get<bool>(value)};
}

}  // namespace

const std::vector<ItemRow>& itemRows() {
  static const std::vector<ItemRow> rows{
      // State.
      {"Robot_Link", 1, [](const V&, N) -> ItemValue { return Byte{1}; }},
      {"Robot_Error", 1, [](const V& v, N) -> ItemValue { return v.state.error; }},
      {"Project_Run", 1, [](const V& v, N) -> ItemValue { return v.state.project_running; }},
      {"Project_Edit", 1, falseBool},
      {"Project_Pause", 1, [](const V& v, N) -> ItemValue { return v.state.project_paused; }},
      {"Get_Control", 1, falseBool},
      {"Safeguard_A", 1, [](const V& v, N) -> ItemValue { return v.state.safeguard; }},
      {"ESTOP", 1, [](const V& v, N) -> ItemValue { return v.state.emergency_stop; }},
      {"Camera_Light", 1, [](const V& v, N) -> ItemValue { return Byte{v.state.camera_light}; }, 0, 9999,
       Access::Always, writeLight},
      {"Robot_Model", 1, [](const V& v, N) -> ItemValue { return upperCase(v.source.arm.name()); }},
      {"Error_Code", 1, [](const V& v, N) -> ItemValue { return std::int32_t{v.state.error_code}; }},
      {"Error_Time", 1,
       [](const V& v, N) -> ItemValue {
         return v.state.error_time ? clockText(*v.state.error_time) : std::string();
       }},
      {"Error_Content", 1, [](const V& v, N) -> ItemValue { return v.state.error_text; }, 0, k180 - 1},
      {"Robot_Mode", 1, zeroInt, 0, k180},
      // Poses. No touch stop was ever made.
      {"Coord_Base_Flange", 1,
       [](const V& v, N) -> ItemValue { return v.poses.told(v.state.base.inverse() * v.state.flange); }},
      {"Coord_Base_Tool", 1,
       [](const V& v, N) -> ItemValue { return v.poses.told(v.state.base.inverse() * v.robot_tool); }},
      {"Coord_Robot_Flange", 1, [](const V& v, N) -> ItemValue { return v.poses.told(v.state.flange); }},
      {"Coord_Robot_Tool", 1, [](const V& v, N) -> ItemValue { return v.poses.told(v.robot_tool); }},
      {"Joint_Angle", 1, [](const V& v, N) -> ItemValue { return degrees(v.state.joints); }},
      {"Touch_Coord_Base_Flange", 1, zeroFloats<6>},
      {"Touch_Joint_Angle_Stop", 1, zeroFloats<6>},
      {"Touch_Coord_Base_Tool", 1, zeroFloats<6>},
      {"Touch_Coord_Robot_Flange", 1, zeroFloats<6>},
      {"Touch_Coord_Robot_Tool", 1, zeroFloats<6>},
      // Dynamics.
      {"TCP_Force", 1, [](const V& v, N) -> ItemValue { return floats(v.state.tcp_force); }},
      {"TCP_Force3D", 1,
       [](const V& v, N) -> ItemValue { return static_cast<float>(v.state.tcp_force.norm()); }},
      {"TCP_Speed", 1, [](const V& v, N) -> ItemValue { return twistFloats(v.tool_twist); }, k180},
      {"TCP_Speed3D", 1, [](const V& v, N) -> ItemValue { return linearSpeed(v.tool_twist); }},
      {"Joint_Speed", 1, [](const V& v, N) -> ItemValue { return degrees(v.state.velocities); }, k180},
      {"Joint_Torque", 1,
       [](const V& v, N) -> ItemValue {
         return floats(jointTorques(v.state, v.source.arm, v.source.settings), kMilli);
       }},
      {"Joint_Torque_Average", 1, torques<&TorqueWindow::average>, k184},
      {"Joint_Torque_Min", 1, torques<&TorqueWindow::least>, k184},
      {"Joint_Torque_Max", 1, torques<&TorqueWindow::most>, k184},
      {"Joint_Current", 1,
       [](const V& v, N) -> ItemValue {
         return floats(jointCurrents(v.state, v.source.arm, v.source.settings), kMilli);
       }},
      {"Joint_Temperature", 1,
       [](const V&, N) -> ItemValue { return Floats(arm::kJointCount, kJointTemperature); }},
      // Tool and base.
      {"TCP_Name", 1, [](const V& v, N) -> ItemValue { return v.state.tcp_name; }},
      {"TCP_Value", 1, [](const V& v, N) -> ItemValue { return v.poses.told(v.state.tcp); }},
      {"TCP_Mass", 1, [](const V& v, N) -> ItemValue { return static_cast<float>(v.state.tcp_mass); }},
      {"TCP_MOI", 1, [](const V& v, N) -> ItemValue { return inertiaMoments(v.state.tcp_inertia); }},
      {"TCP_MCF", 1, [](const V& v, N) -> ItemValue { return massCenter(v.state.tcp_inertia); }},
      {"Base_Name", 1, [](const V& v, N) -> ItemValue { return v.state.base_name; }},
      {"Base_Value", 1, [](const V& v, N) -> ItemValue { return v.poses.told(v.state.base); }},
      {"HandCamera_Value", 1,
       [](const V& v, N) -> ItemValue {
         return v.poses.told(v.source.project.tools.at("HandCamera").now.frame.pose);
       }},
      // The project, and the stick. A button is up again before anybody can read it.
      {"Project_Name", 1, [](const V& v, N) -> ItemValue { return v.source.settings.project_name; }, 0, 9999,
       Access::Automatic, writeName},
      {"Project_Speed", 1,
       [](const V& v, N) -> ItemValue { return std::int32_t{v.state.project_speed_percent}; }, 0, 9999,
       Access::Automatic, writeSpeed},
      {"MA_Mode", 1, [](const V& v, N) -> ItemValue { return static_cast<std::int32_t>(v.state.mode); }},
      {"Stick_Power", 1, [](const V&, N) -> ItemValue { return true; }},
      {"Stick_MA", 1, falseBool},
      {"Stick_PlayPause", 1, falseBool, 0, 9999, Access::Automatic, press<Button::PlayPause>},
      {"Stick_Plus", 1, falseBool, 0, 9999, Access::Automatic, press<Button::Plus>},
      {"Stick_Minus", 1, falseBool, 0, 9999, Access::Automatic, press<Button::Minus>},
      {"Stick_Stop", 1, falseBool, 0, 9999, Access::Always, press<Button::Stop>},
      {"End_FreeBot", 1, falseBool},
      // Limits of the safety functions and of collaborative operation: only what the arm itself cannot
      // exceed, and what the settings have.
      {"Safety_TCP_Speed", 1, zeroFloat},
      {"Safety_TCP_Speed_HandGuide", 1, zeroFloat},
      {"Safety_TCP_Force", 1, zeroFloat},
      {"Safety_Joint_Speed", 1,
       [](const V& v, N) -> ItemValue { return jointLimits(v.source.arm, &arm::JointLimit::max_velocity); }},
      {"Safety_Joint_Torque", 1, zeroFloats<6>},
      {"Safety_Joint_Angle_Min", 1,
       [](const V& v, N) -> ItemValue { return safetyLimits(v.source, &arm::JointLimit::lower); }},
      {"Safety_Joint_Angle_Max", 1,
       [](const V& v, N) -> ItemValue { return safetyLimits(v.source, &arm::JointLimit::upper); }},
      {"Safety_GSensor", 1, falseBool},
      {"Col_TCP_Speed", 1, zeroFloat},
      {"Col_TCP_Speed_HandGuide", 1, zeroFloat},
      {"Col_TCP_Force", 1, zeroFloat},
      {"Col_Joint_Speed", 1, zeroFloats<6>},
      {"Col_Joint_Torque", 1, zeroFloats<6>},
      {"Col_Motion_Speed", 1, zeroFloat},
      {"Col_PTP_Speed", 1, zeroFloat},
      {"Col_Deceleration_Time", 1, zeroInt},
      {"Col_Contact_Area", 1, zeroFloat},
      {"Speed_Adjust_Enable", 1, [](const V&, N) -> ItemValue { return true; }},
      {"Auto_Remote_Enable", 1, [](const V&, N) -> ItemValue { return true; }},
      {"Auto_Remote_Active", 1, [](const V& v, N) -> ItemValue { return v.state.auto_remote; }, 0, 9999,
       Access::Automatic, writeAutoRemote},
      // The controller.
      {"ControlBox_SN", 1, [](const V&, N) -> ItemValue { return std::string("SIMULATED"); }},
      {"Controller_Temperature", 1, [](const V&, N) -> ItemValue { return kControllerTemperature; }},
      {"Manipulator_Voltage", 1, [](const V&, N) -> ItemValue { return static_cast<float>(kArmVoltage); }},
      {"Manipulator_Consumption", 1,
       [](const V& v, N) -> ItemValue { return static_cast<float>(kArmVoltage * armCurrent(v)); }},
      {"Manipulator_Current", 1,
       [](const V& v, N) -> ItemValue { return static_cast<float>(armCurrent(v)); }},
      {"ControlBox_IO_Current", 1, zeroFloat},
      {"End_IO_Current", 1, zeroFloat},
      {"Current_Time", 1, [](const V& v, N) -> ItemValue { return clockText(v.state.time); }},
      {"Project_Run_Time", 1,
       [](const V& v, N) -> ItemValue {
         return durationText(v.state.project_running ? v.state.time - v.state.project_started
                                                     : Duration::zero());
       }},
      {"System_Uptime", 1,
       [](const V& v, N) -> ItemValue { return durationText(v.state.time - v.state.started); }},
      {"TMflow_Version", 1, [](const V& v, N) -> ItemValue { return v.source.settings.tmflow_version; }},
      {"DHTable", 1, [](const V& v, N) -> ItemValue { return dhTable(v.source.arm); }, k180},
      {"DeltaDH", 1, zeroFloats<30>},
      {"Robot_Light", 1, [](const V& v, N) -> ItemValue { return std::int32_t{robotLight(v.state)}; }},
      // Inputs and outputs. Only the digital ones and the first analog one of the control box can be set.
      {"SO#", 5, zeroByte},
      {"SI#", 5, zeroByte},
      {"Ctrl_DO#", 16, output<IoModule::ControlBox>, 0, 9999, Access::Always,
       writeOutput<IoModule::ControlBox>},
      {"Ctrl_DI#", 16, input<IoModule::ControlBox>},
      {"Ctrl_AO0", 1, [](const V& v, N) -> ItemValue { return v.state.analog_output; }, 0, 9999,
       Access::Always, writeAnalog},
      {"Ctrl_AO1", 1, zeroFloat, 0, k180},
      {"Ctrl_AI#", 2, zeroFloat},
      {"End_DO#", 4, output<IoModule::EndModule>, 0, 9999, Access::Always, writeOutput<IoModule::EndModule>},
      {"End_DI#", 4, input<IoModule::EndModule>},
      {"End_AI0", 1, zeroFloat},
      {"End_AO0", 1, zeroFloat, 0, k180},
      {"Ext#_DO", 8, zeroBytes, 0, k180},
      {"Ext#_DO_Mask", 8, zeroBytes, 0, k180},
      {"Ext#_DI", 8, zeroBytes, 0, k180},
      {"Ext#_DI_Mask", 8, zeroBytes, 0, k180},
      {"Ext#_AO", 8, zeroFloats<8>, 0, k180},
      {"Ext#_AI", 8, zeroFloats<8>, 0, k180},
  };
  return rows;
}

}  // namespace cobot_command::simulator
