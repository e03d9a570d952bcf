#include "item_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <utility>
#include <variant>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

namespace {

using protocol::StatusItem;
using Byte = std::uint8_t;
using Floats = std::vector<float>;
/// The wire types that the table needs.
using Value = std::variant<bool, Byte, std::int32_t, float, Floats, std::string>;

/// What several items need, computed once a frame.
struct Values {
  explicit Values(const ItemSource& from)
      : source(from), state(from.state), robot_tool(state.flange * state.tcp), tool_twist(twistOf(from)) {}

  static Eigen::Matrix<double, 6, 1> twistOf(const ItemSource& from) {
    const RobotState& robot = from.state;
    Eigen::Matrix<double, 6, 1> twist = arm::jacobianAt(from.arm, robot.joints) * robot.velocities;
    const Eigen::Vector3d lever = robot.flange.linear() * robot.tcp.translation();
    const Eigen::Vector3d angular = twist.tail<3>();
    twist.head<3>() += angular.cross(lever);
    return twist;
  }

  const ItemSource& source;
  const RobotState& state;
  arm::Pose robot_tool;                    ///< the TCP in the robot base [m]
  Eigen::Matrix<double, 6, 1> tool_twist;  ///< of the TCP in the robot base [m/s, rad/s]
};

Floats poseFloats(const arm::Pose& pose) {
  const arm::ControllerPose numbers = arm::toControllerPose(pose);
  Floats floats;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(floats),
                 [](double number) { return static_cast<float>(number); });
  return floats;
}

Floats degrees(const arm::JointVector& joints) {
  Floats floats;
  for (const double joint : joints) floats.push_back(static_cast<float>(radToDeg(joint)));
  return floats;
}

Floats twistFloats(const Eigen::Matrix<double, 6, 1>& twist) {
  Floats floats;
  for (int i = 0; i < 6; ++i) {
    floats.push_back(static_cast<float>(i < 3 ? mToMm(twist[i]) : radToDeg(twist[i])));
  }
  return floats;
}

float speed(const Eigen::Matrix<double, 6, 1>& twist) {
  return static_cast<float>(mToMm(twist.head<3>().norm()));
}

int robotLight(const RobotState& state) {
  constexpr int kOff = 0;
  constexpr struct { int standby, running, error; } kAutomatic{3, 4, 9}, kManual{5, 6, 10};
  if (state.emergency_stop) return kOff;
  const auto& lights = state.mode == OperatingMode::Manual ? kManual : kAutomatic;
  if (state.error) return lights.error;
  return state.project_running ? lights.running : lights.standby;
}

std::string upperCase(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return name;
}

/// Six rows of offset, alpha, a, d, type, lower and upper limit; mm and degrees.
Floats dhTable(const arm::ArmModel& model) {
  const arm::DhLengths& l = model.lengths();
  const std::array<std::array<double, 4>, arm::kJointCount> rows{{{0, -90, 0, l.d1},
                                                                  {-90, 0, l.a2, 0},
                                                                  {0, 0, l.a3, 0},
                                                                  {90, 90, 0, l.d4},
                                                                  {0, 90, 0, l.d5},
                                                                  {0, 0, 0, l.d6}}};
  Floats table;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const arm::JointLimit& limit = model.limits()[i];
    for (const double number : {rows[i][0], rows[i][1], mToMm(rows[i][2]), mToMm(rows[i][3]), 0.0,
                                radToDeg(limit.lower), radToDeg(limit.upper)}) {
      table.push_back(static_cast<float>(number));
    }
  }
  return table;
}

struct Entry {
  const char* name;
  bool streamed;
  Value (*value)(const Values&);
};

template <std::size_t Index>
Value boxOutput(const Values& v) {
  return Byte{v.state.outputs.control_box[Index]};
}
template <std::size_t Index>
Value boxInput(const Values& v) {
  return Byte{v.state.inputs.control_box[Index]};
}
template <std::size_t Index>
Value endOutput(const Values& v) {
  return Byte{v.state.outputs.end_module[Index]};
}
template <std::size_t Index>
Value endInput(const Values& v) {
  return Byte{v.state.inputs.end_module[Index]};
}

// What the simulation has no quantity for: forces, torques, analog inputs and outputs.
Value zeroByte(const Values&) {
  return Byte{0};
}
Value zeroFloat(const Values&) {
  return 0.0F;
}
template <std::size_t Size>
Value zeroFloats(const Values&) {
  return Floats(Size, 0.0F);
}

constexpr Entry kEntries[] = {
    // The table of the vendor's driver, in its order.
    {"Robot_Link", true, [](const Values&) -> Value { return Byte{1}; }},
    {"Robot_Error", true, [](const Values& v) -> Value { return v.state.error; }},
    {"Project_Run", true, [](const Values& v) -> Value { return v.state.project_running; }},
    {"Project_Pause", true, [](const Values& v) -> Value { return v.state.project_paused; }},
    {"Safeguard_A", true, [](const Values& v) -> Value { return v.state.safeguard; }},
    {"ESTOP", true, [](const Values& v) -> Value { return v.state.emergency_stop; }},
    {"Camera_Light", true, zeroByte},
    {"Error_Code", true, [](const Values& v) -> Value { return std::int32_t{v.state.error_code}; }},
    {"Joint_Angle", true, [](const Values& v) -> Value { return degrees(v.state.joints); }},
    {"Coord_Robot_Flange", true, [](const Values& v) -> Value { return poseFloats(v.state.flange); }},
    {"Coord_Robot_Tool", true, [](const Values& v) -> Value { return poseFloats(v.robot_tool); }},
    {"TCP_Force", true, zeroFloats<3>},
    {"TCP_Force3D", true, zeroFloat},
    {"TCP_Speed", true, [](const Values& v) -> Value { return twistFloats(v.tool_twist); }},
    {"TCP_Speed3D", true, [](const Values& v) -> Value { return speed(v.tool_twist); }},
    {"Joint_Speed", true, [](const Values& v) -> Value { return degrees(v.state.velocities); }},
    {"Joint_Torque", true, zeroFloats<6>},
    {"Project_Speed", true,
     [](const Values& v) -> Value { return std::int32_t{v.state.project_speed_percent}; }},
    {"MA_Mode", true, [](const Values& v) -> Value { return static_cast<std::int32_t>(v.state.mode); }},
    {"Robot_Light", true, [](const Values& v) -> Value { return std::int32_t{robotLight(v.state)}; }},
    {"Ctrl_DO0", true, boxOutput<0>},
    {"Ctrl_DO1", true, boxOutput<1>},
    {"Ctrl_DO2", true, boxOutput<2>},
    {"Ctrl_DO3", true, boxOutput<3>},
    {"Ctrl_DO4", true, boxOutput<4>},
    {"Ctrl_DO5", true, boxOutput<5>},
    {"Ctrl_DO6", true, boxOutput<6>},
    {"Ctrl_DO7", true, boxOutput<7>},
    {"Ctrl_DI0", true, boxInput<0>},
    {"Ctrl_DI1", true, boxInput<1>},
    {"Ctrl_DI2", true, boxInput<2>},
    {"Ctrl_DI3", true, boxInput<3>},
    {"Ctrl_DI4", true, boxInput<4>},
    {"Ctrl_DI5", true, boxInput<5>},
    {"Ctrl_DI6", true, boxInput<6>},
    {"Ctrl_DI7", true, boxInput<7>},
    {"Ctrl_AO0", true, zeroFloat},
    {"Ctrl_AI0", true, zeroFloat},
    {"Ctrl_AI1", true, zeroFloat},
    {"End_DO0", true, endOutput<0>},
    {"End_DO1", true, endOutput<1>},
    {"End_DO2", true, endOutput<2>},
    {"End_DO3", true, endOutput<3>},
    {"End_DI0", true, endInput<0>},
    {"End_DI1", true, endInput<1>},
    {"End_DI2", true, endInput<2>},
    {"End_AI0", true, zeroFloat},
    // Beyond it: what says which tool and base the poses are for, and the error in words.
    {"TCP_Name", true, [](const Values& v) -> Value { return v.state.tcp_name; }},
    {"TCP_Value", true, [](const Values& v) -> Value { return poseFloats(v.state.tcp); }},
    {"TCP_Mass", true, [](const Values& v) -> Value { return static_cast<float>(v.state.tcp_mass); }},
    {"Base_Name", true, [](const Values& v) -> Value { return v.state.base_name; }},
    {"Base_Value", true, [](const Values& v) -> Value { return poseFloats(v.state.base); }},
    {"Coord_Base_Flange", true,
     [](const Values& v) -> Value { return poseFloats(v.state.base.inverse() * v.state.flange); }},
    {"Coord_Base_Tool", true,
     [](const Values& v) -> Value { return poseFloats(v.state.base.inverse() * v.robot_tool); }},
    {"Error_Content", true, [](const Values& v) -> Value { return v.state.error_text; }},
    // Only on request: the terminals beyond the table, and what never changes.
    {"Ctrl_DO8", false, boxOutput<8>},
    {"Ctrl_DO9", false, boxOutput<9>},
    {"Ctrl_DO10", false, boxOutput<10>},
    {"Ctrl_DO11", false, boxOutput<11>},
    {"Ctrl_DO12", false, boxOutput<12>},
    {"Ctrl_DO13", false, boxOutput<13>},
    {"Ctrl_DO14", false, boxOutput<14>},
    {"Ctrl_DO15", false, boxOutput<15>},
    {"Ctrl_DI8", false, boxInput<8>},
    {"Ctrl_DI9", false, boxInput<9>},
    {"Ctrl_DI10", false, boxInput<10>},
    {"Ctrl_DI11", false, boxInput<11>},
    {"Ctrl_DI12", false, boxInput<12>},
    {"Ctrl_DI13", false, boxInput<13>},
    {"Ctrl_DI14", false, boxInput<14>},
    {"Ctrl_DI15", false, boxInput<15>},
    {"End_DI3", false, endInput<3>},
    {"Robot_Model", false, [](const Values& v) -> Value { return upperCase(v.source.arm.name()); }},
    {"TMflow_Version", false, [](const Values& v) -> Value { return v.source.settings.tmflow_version; }},
    {"Project_Name", false, [](const Values& v) -> Value { return v.source.settings.project_name; }},
    {"DHTable", false, [](const Values& v) -> Value { return dhTable(v.source.arm); }},
};

StatusItem make(const Entry& entry, const Values& values) {
  struct Maker {
    std::string name;
    StatusItem operator()(bool value) { return protocol::item::ofBool(name, value); }
    StatusItem operator()(Byte value) { return protocol::item::ofByte(name, value); }
    StatusItem operator()(std::int32_t value) { return protocol::item::ofInt(name, value); }
    StatusItem operator()(float value) { return protocol::item::ofFloat(name, value); }
    StatusItem operator()(const Floats& value) { return protocol::item::ofFloats(name, value); }
    StatusItem operator()(const std::string& value) { return protocol::item::ofString(name, value); }
  };
  return std::visit(Maker{entry.name}, entry.value(values));
}

const Entry* find(std::string_view name) {
  const auto* const entry = std::find_if(std::begin(kEntries), std::end(kEntries),
                                         [&](const Entry& candidate) { return candidate.name == name; });
  return entry == std::end(kEntries) ? nullptr : entry;
}

bool isHidden(std::string_view name, const FaultSwitch& hidden) {
  if (!hidden.on) return false;
  std::istringstream names(hidden.text);
  const std::istream_iterator<std::string> first(names), last;
  return std::find(first, last, name) != last;
}

}  // namespace

bool isItem(std::string_view name) {
  return find(name) != nullptr;
}

std::vector<StatusItem> streamedItems(const ItemSource& source) {
  const Values values(source);
  std::vector<StatusItem> items;
  items.reserve(std::size(kEntries));
  for (const Entry& entry : kEntries) {
    if (entry.streamed && !isHidden(entry.name, source.hidden)) items.push_back(make(entry, values));
  }
  return items;
}

std::optional<StatusItem> itemNamed(std::string_view name, const ItemSource& source) {
  const Entry* entry = find(name);
  if (entry == nullptr || isHidden(name, source.hidden)) return std::nullopt;
  return make(*entry, Values(source));
}

}  // namespace cobot_command::simulator
