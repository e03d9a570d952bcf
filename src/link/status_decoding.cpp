#include "status_decoding.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/units.h"
#include "cobot_command/link/stream_items.h"
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

struct ItemRow {
  StreamItem item;
  bool (*read)(const StatusItem&, RobotStatus&);
  bool (*is_there)(const RobotStatus&);
};

template <auto Member, auto Read>
constexpr ItemRow row(std::string_view name, ItemNeed need, std::string_view without) {
  return {{name, need, without},
          [](const StatusItem& item, RobotStatus& status) { return Read(item, status.*Member); },
          [](const RobotStatus& status) { return (status.*Member).has_value(); }};
}

template <auto Member>
constexpr ItemRow identityRow(std::string_view name) {
  return {
      {name, ItemNeed::Choice, "it is queried from the controller"},
      [](const StatusItem& item, RobotStatus& status) { return readString(item, status.identity.*Member); },
      [](const RobotStatus& status) { return (status.identity.*Member).has_value(); }};
}

// What each is called, and what is so without it: doc/real-robot.md has this table, and the names of those
// that every data table should have. Error_Content is streamed by TMflow 1.76 and older only, which do not
// have Joint_Speed (TM 3.1).
constexpr ItemRow kItems[] = {
    row<&RobotStatus::error, readBool>("Robot_Error", ItemNeed::Ready,
                                       "errors of the controller are not detected: a failure is reported "
                                       "without its cause, and the next motion is not refused"),
    row<&RobotStatus::project_running, readBool>(
        "Project_Run", ItemNeed::Ready, "it is not detected whether the project runs or has stopped"),
    row<&RobotStatus::project_paused, readBool>("Project_Pause", ItemNeed::Ready,
                                                "a pause by others is not detected: the deadlines of motions "
                                                "continue to run, and no goal shows HELD"),
    row<&RobotStatus::safeguard, readBool>("Safeguard_A", ItemNeed::Ready,
                                           "a safeguard that stops the robot is not detected: the deadlines "
                                           "of motions continue to run, and no goal shows HELD"),
    row<&RobotStatus::emergency_stop, readBool>(
        "ESTOP", ItemNeed::Ready, "an emergency stop is not detected: goals end as after a lost link"),
    row<&RobotStatus::error_code, readInt>("Error_Code", ItemNeed::Always,
                                           "errors of the controller have no number and no text"),
    row<&RobotStatus::joints, readJoints>(
        "Joint_Angle", ItemNeed::Ready,
        "no joint_states; moves are sent unplanned and unchecked, and their end positions are not confirmed; "
        "jog, paths, trajectories and interrupt are refused"),
    row<&RobotStatus::joint_velocities, readJoints>(
        "Joint_Speed", ItemNeed::Always,
        "no velocities in joint_states; standstill is detected 0.3 s later, by the joint angles (TMflow 1.76 "
        "does not have it)"),
    row<&RobotStatus::joint_torques, readTorques>("Joint_Torque", ItemNeed::Always,
                                                  "no efforts in joint_states"),
    row<&RobotStatus::flange, readPose>("Coord_Robot_Flange", ItemNeed::Always,
                                        "if TCP_Value is also missing, the active tool is unknown"),
    row<&RobotStatus::tool, readPose>("Coord_Robot_Tool", ItemNeed::Always,
                                      "no tool_pose, no final_pose; whether a pose was reached is judged by "
                                      "the nominal model alone, to 10 mm"),
    row<&RobotStatus::tcp, readPose>("TCP_Value", ItemNeed::Always,
                                     "until change_tcp the active tool is known only from flange and tool "
                                     "pose; without these it is not confirmed whether a pose was reached"),
    row<&RobotStatus::tcp_name, readString>("TCP_Name", ItemNeed::Always, "the active tool has no name here"),
    row<&RobotStatus::base, readPose>("Base_Value", ItemNeed::Always,
                                      "until change_base the active base is unknown: targets in a tf frame "
                                      "are refused, and it is not confirmed whether a pose was reached"),
    row<&RobotStatus::base_name, readString>("Base_Name", ItemNeed::Always,
                                             "the active base has no name here"),
    row<&RobotStatus::project_speed_percent, readInt>(
        "Project_Speed", ItemNeed::Always,
        "plans are made for a project speed of 100 %: at a lower one motions take longer than planned"),
    row<&RobotStatus::operating_mode, readInt>("MA_Mode", ItemNeed::Always,
                                               "manual mode is not detected; robots in a cell do not move"),
    {{"Ctrl_DI0", ItemNeed::Choice, "the level is UNKNOWN in digital_io, and wait_for_input is refused"},
     nullptr,
     nullptr},
    {{"Ctrl_DO0", ItemNeed::Choice, "the level is UNKNOWN in digital_io"}, nullptr, nullptr},
    {{"End_DI0", ItemNeed::Choice, "the level is UNKNOWN in digital_io, and wait_for_input is refused"},
     nullptr,
     nullptr},
    {{"End_DO0", ItemNeed::Choice, "the level is UNKNOWN in digital_io"}, nullptr, nullptr},
    row<&RobotStatus::tcp_mass, readMass>("TCP_Mass", ItemNeed::Choice,
                                          "the mass of the tool is known only from change_tcp on"),
    row<&RobotStatus::tool_speed, readSpeed>(
        "TCP_Speed3D", ItemNeed::Choice,
        "group_state does not show whether the tool accelerates or decelerates"),
    row<&RobotStatus::safety_lower, readJoints>("Safety_Joint_Angle_Min", ItemNeed::Choice,
                                                "the software limits are not compared with the controller's"),
    row<&RobotStatus::safety_upper, readJoints>("Safety_Joint_Angle_Max", ItemNeed::Choice,
                                                "the software limits are not compared with the controller's"),
    identityRow<&ControllerIdentity::robot_model>("Robot_Model"),
    identityRow<&ControllerIdentity::control_box_sn>("ControlBox_SN"),
    identityRow<&ControllerIdentity::tmflow_version>("TMflow_Version"),
    row<&RobotStatus::error_text, readString>(
        "Error_Content", ItemNeed::Choice,
        "errors have the built-in text for their code (TMflow after 1.76 does not have this item)"),
    row<&RobotStatus::linked, readBool>("Robot_Link", ItemNeed::Choice, "nothing depends on it"),
};

constexpr const char* kDataTable = "TMflow, Setting > Connection > Ethernet Slave > Data Table";

std::vector<StreamItem> missingIn(const RobotStatus& status, ItemNeed least) {
  std::vector<StreamItem> missing;
  for (const ItemRow& row : kItems) {
    if (row.item.need > least || row.is_there == nullptr || row.is_there(status)) continue;
    const auto& unreadable = status.unreadable;
    if (std::find(unreadable.begin(), unreadable.end(), row.item.name) != unreadable.end()) continue;
    missing.push_back(row.item);
  }
  return missing;
}

}  // namespace

RobotStatus toRobotStatus(const std::vector<StatusItem>& items, Instant received) {
  RobotStatus status;
  status.received = received;
  for (const StatusItem& item : items) {
    const auto* row = std::find_if(std::begin(kItems), std::end(kItems), [&](const ItemRow& known) {
      return known.read != nullptr && known.item.name == item.name;
    });
    const bool read = row != std::end(kItems) ? row->read(item, status) : readIfLevel(item, status);
    if (!read) status.unreadable.emplace_back(item.name);
  }
  const std::string_view meaning = protocol::meaningOfError(status.error_code.value_or(0));
  if (!status.error_text && !meaning.empty()) status.error_text = meaning;
  return status;
}

const std::vector<StreamItem>& streamItems() {
  static const std::vector<StreamItem> items = [] {
    std::vector<StreamItem> all;
    for (const ItemRow& row : kItems) all.push_back(row.item);
    return all;
  }();
  return items;
}

std::vector<StreamItem> missingItems(const RobotStatus& status) {
  return missingIn(status, ItemNeed::Always);
}

std::vector<StreamItem> missingForReady(const RobotStatus& status) {
  return missingIn(status, ItemNeed::Ready);
}

std::string describe(const std::vector<StreamItem>& missing) {
  std::string text;
  for (const StreamItem& item : missing) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", item.name, item.without);
  }
  return text;
}

std::string namesOf(const std::vector<StreamItem>& items) {
  std::string names;
  for (const StreamItem& item : items) names.append(names.empty() ? "" : ", ").append(item.name);
  return names;
}

std::string lackOf(std::string_view item) {
  assert(std::any_of(std::begin(kItems), std::end(kItems),
                     [item](const ItemRow& row) { return row.item.name == item; }));
  return fmt::format("the status stream does not have {}: tick it in {}", item, kDataTable);
}

std::string remedyForMissingItems() {
  return fmt::format("tick them in {}", kDataTable);
}

}  // namespace cobot_command::link
