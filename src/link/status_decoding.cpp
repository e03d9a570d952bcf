#include "status_decoding.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/units.h"
#include "cobot_command/protocol/controller_error.h"

namespace cobot_command::link {
namespace {

using protocol::StatusItem;

std::optional<std::array<double, 6>> sixNumbers(const StatusItem& item) {
  const auto floats = protocol::item::asFloats(item);
  if (!floats || floats->size() != 6) return std::nullopt;
  if (!std::all_of(floats->begin(), floats->end(), [](float f) { return std::isfinite(f); })) {
    return std::nullopt;
  }
  std::array<double, 6> numbers{};
  std::copy(floats->begin(), floats->end(), numbers.begin());
  return numbers;
}

// Each returns whether the item could be read.

bool readJoints(const StatusItem& item, std::optional<arm::JointVector>& target) {
  if (const auto numbers = sixNumbers(item)) target = arm::toJointVector(*numbers);
  return target.has_value();
}

bool readTorques(const StatusItem& item, std::optional<arm::JointVector>& target) {
  constexpr double kNewtonmetresPerMillinewtonmetre = 1e-3;
  const auto numbers = sixNumbers(item);
  if (!numbers) return false;
  target = arm::JointVector(Eigen::Map<const arm::JointVector>(numbers->data()) *
                            kNewtonmetresPerMillinewtonmetre);
  return true;
}

bool readPose(const StatusItem& item, std::optional<arm::Pose>& target) {
  if (const auto numbers = sixNumbers(item)) target = arm::toPose(*numbers);
  return target.has_value();
}

bool readMass(const StatusItem& item, std::optional<double>& target) {
  const auto value = protocol::item::asFloat(item);
  if (value && std::isfinite(*value)) target = *value;
  return target.has_value();
}

bool readBool(const StatusItem& item, std::optional<bool>& target) {
  if (const auto value = protocol::item::asBool(item)) target = value;
  return target.has_value();
}

bool readSpeed(const StatusItem& item, std::optional<double>& target) {
  const auto value = protocol::item::asFloat(item);
  if (value && std::isfinite(*value)) target = mmToM(*value);
  return target.has_value();
}

bool readInt(const StatusItem& item, std::optional<int>& target) {
  if (const auto value = protocol::item::asInt(item)) target = *value;
  return target.has_value();
}

bool readString(const StatusItem& item, std::optional<std::string>& target) {
  target = foreignText(item.value);
  return true;
}

/// Of a digital input or output, a byte that is 0 or 1.
template <std::size_t N>
bool readLevel(const StatusItem& item, std::string_view prefix, std::array<std::optional<bool>, N>& levels) {
  const std::string_view number = std::string_view(item.name).substr(prefix.size());
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc() || end != number.data() + number.size() || index >= N) {
    return true;  // another item
  }
  const auto level = protocol::item::asByte(item);
  if (level && *level <= 1) levels[index] = *level == 1;
  return levels[index].has_value();
}

bool readIfLevel(const StatusItem& item, RobotStatus& status) {
  const auto begins = [name = std::string_view(item.name)](std::string_view prefix) {
    return name.substr(0, prefix.size()) == prefix;
  };
  constexpr std::string_view kBoxInput = "Ctrl_DI", kBoxOutput = "Ctrl_DO";
  constexpr std::string_view kEndInput = "End_DI", kEndOutput = "End_DO";
  if (begins(kBoxInput)) return readLevel(item, kBoxInput, status.inputs.control_box);
  if (begins(kBoxOutput)) return readLevel(item, kBoxOutput, status.outputs.control_box);
  if (begins(kEndInput)) return readLevel(item, kEndInput, status.inputs.end_module);
  if (begins(kEndOutput)) return readLevel(item, kEndOutput, status.outputs.end_module);
  return true;
}

using Reader = bool (*)(const StatusItem&, RobotStatus&);
struct ItemRow {
  std::string_view name;
  Reader read;
};

// Error_Content is streamed by TMflow 1.76 and older only (TM 3.1).
constexpr ItemRow kItems[] = {
    {"Robot_Link", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.linked); }},
    {"Joint_Angle", [](const StatusItem& i, RobotStatus& s) { return readJoints(i, s.joints); }},
    {"Joint_Speed", [](const StatusItem& i, RobotStatus& s) { return readJoints(i, s.joint_velocities); }},
    {"Joint_Torque", [](const StatusItem& i, RobotStatus& s) { return readTorques(i, s.joint_torques); }},
    {"Safety_Joint_Angle_Min",
     [](const StatusItem& i, RobotStatus& s) { return readJoints(i, s.safety_lower); }},
    {"Safety_Joint_Angle_Max",
     [](const StatusItem& i, RobotStatus& s) { return readJoints(i, s.safety_upper); }},
    {"Coord_Robot_Flange", [](const StatusItem& i, RobotStatus& s) { return readPose(i, s.flange); }},
    {"Coord_Robot_Tool", [](const StatusItem& i, RobotStatus& s) { return readPose(i, s.tool); }},
    {"Base_Value", [](const StatusItem& i, RobotStatus& s) { return readPose(i, s.base); }},
    {"TCP_Value", [](const StatusItem& i, RobotStatus& s) { return readPose(i, s.tcp); }},
    {"TCP_Mass", [](const StatusItem& i, RobotStatus& s) { return readMass(i, s.tcp_mass); }},
    {"TCP_Speed3D", [](const StatusItem& i, RobotStatus& s) { return readSpeed(i, s.tool_speed); }},
    {"Base_Name", [](const StatusItem& i, RobotStatus& s) { return readString(i, s.base_name); }},
    {"TCP_Name", [](const StatusItem& i, RobotStatus& s) { return readString(i, s.tcp_name); }},
    {"Robot_Error", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.error); }},
    {"Error_Code", [](const StatusItem& i, RobotStatus& s) { return readInt(i, s.error_code); }},
    {"Error_Content", [](const StatusItem& i, RobotStatus& s) { return readString(i, s.error_text); }},
    {"ESTOP", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.emergency_stop); }},
    {"Safeguard_A", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.safeguard); }},
    {"Project_Run", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.project_running); }},
    {"Project_Pause", [](const StatusItem& i, RobotStatus& s) { return readBool(i, s.project_paused); }},
    {"Project_Speed",
     [](const StatusItem& i, RobotStatus& s) { return readInt(i, s.project_speed_percent); }},
    {"MA_Mode", [](const StatusItem& i, RobotStatus& s) { return readInt(i, s.operating_mode); }},
    {"Robot_Model",
     [](const StatusItem& i, RobotStatus& s) { return readString(i, s.identity.robot_model); }},
    {"ControlBox_SN",
     [](const StatusItem& i, RobotStatus& s) { return readString(i, s.identity.control_box_sn); }},
    {"TMflow_Version",
     [](const StatusItem& i, RobotStatus& s) { return readString(i, s.identity.tmflow_version); }},
};

}  // namespace

RobotStatus toRobotStatus(const std::vector<StatusItem>& items, Instant received) {
  RobotStatus status;
  status.received = received;
  for (const StatusItem& item : items) {
    const auto* row = std::find_if(std::begin(kItems), std::end(kItems),
                                   [&](const ItemRow& known) { return known.name == item.name; });
    const bool read = row != std::end(kItems) ? row->read(item, status) : readIfLevel(item, status);
    if (!read) status.unreadable.emplace_back(item.name);
  }
  const std::string_view meaning = protocol::meaningOfError(status.error_code.value_or(0));
  if (!status.error_text && !meaning.empty()) status.error_text = meaning;
  return status;
}

}  // namespace cobot_command::link
