#include "reading/step_goals.h"

#include <array>
#include <functional>

#include "reading/names.h"
#include "reading/shape_reading.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/files/steps/steps_file.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;
using files::YamlNames;
using Keys = std::vector<std::string>;

const YamlNames kRelativeFormats{{"JPP", 0}, {"CPP", 1}, {"CPR", 2}, {"CAP", 3}, {"CAR", 4},
                                 {"TPP", 5}, {"TPR", 6}, {"TAP", 7}, {"TAR", 8}};
const YamlNames kCircleFormats{{"CPP", 0}, {"CAP", 1}};

const Keys kCommon{"name", "block"};
/// What a robot does that stands at the target of its step.
const Keys kAtTarget{"attach", "output", "input", "dwell", "detach"};
const Keys kMotion{"command_id",      "data_format",    "speed",     "accel_time",
                   "blending_enable", "blending_value", "exit_node", "disable_precise_positioning"};

const Station& stationIn(const YamlMap& map, const char* key, const Robot& robot) {
  const YAML::Node node = map.required(key);
  const Station* station = find(robot.stations, node.Scalar());
  if (station == nullptr) {
    refuseUnknown(node.Mark(), key, node.Scalar(), "station of the robot or six numbers",
                  namesOf(robot.stations));
  }
  return *station;
}

/// Six numbers, or the pose of a station, which is found when all of the program is there.
blocks::SixValues poseIn(const YamlMap& map, const char* key, const Robot& robot, Step& step) {
  if (!map.required(key).IsScalar()) return files::toSix(map, key);
  step.at = stationIn(map, key, robot).name;
  return {};
}

blocks::SixValues jointsIn(const YamlMap& map, const char* key, const Robot& robot) {
  return map.required(key).IsScalar() ? stationIn(map, key, robot).degrees : files::toSix(map, key);
}

void moveAbsolute(const YamlMap& map, const Robot& robot, Step& step) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = map.named("movement_command", files::movementNames());
  goal.data_format = files::toAbsoluteFormat(map, goal.movement_command, "add block: move_relative");
  const bool has_joints = goal.data_format == static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target =
      has_joints ? jointsIn(map, "target_position", robot) : poseIn(map, "target_position", robot, step);
  files::takeMotion(map, goal);
  files::takePosture(map, goal);
  step.goal = goal;
}

void moveRelative(const YamlMap& map, const Robot& /*robot*/, Step& step) {
  blocks::MoveRelativeGoal goal;
  goal.movement_command = map.named("movement_command", files::movementNames());
  goal.data_format = files::toFormat(map, goal.movement_command, kRelativeFormats);
  goal.target = files::toSix(map, "target_position");
  files::takeMotion(map, goal);
  step.goal = goal;
}

void moveCircle(const YamlMap& map, const Robot& robot, Step& step) {
  blocks::MoveCircleGoal goal;
  goal.data_format = map.named("data_format", kCircleFormats);
  goal.arc_point = files::toSix(map, "arc_point");
  goal.end_point = poseIn(map, "end_point", robot, step);
  if (map.has("arc_angle")) goal.arc_angle = map.number("arc_angle");
  files::takeMotion(map, goal);
  step.goal = goal;
}

void changeBase(const YamlMap& map, const Robot& /*robot*/, Step& step) {
  blocks::ChangeBaseGoal goal;
  goal.transformation = frameIn(map, "base", "base");
  step.goal = goal;
}

void changeTcp(const YamlMap& map, const Robot& /*robot*/, Step& step) {
  blocks::ChangeTcpGoal goal;
  goal.tcp_offset = frameIn(map, "tcp", "TCP");
  if (map.has("weight")) goal.weight = map.number("weight");
  if (map.has("moment_of_inertia")) {
    const YAML::Node moments = map.list("moment_of_inertia", goal.moment_of_inertia.size());
    for (std::size_t i = 0; i < goal.moment_of_inertia.size(); ++i) {
      goal.moment_of_inertia[i] = files::toNumber(moments[i], fmt::format("moment_of_inertia[{}]", i));
    }
  }
  if (map.has("mass_center")) goal.mass_center = files::toSix(map, "mass_center");
  step.goal = goal;
}

void script(const YamlMap& map, const Robot& /*robot*/, Step& step) {
  blocks::RunScriptGoal goal;
  goal.script = map.text("script");
  goal.await_motion = true;
  step.goal = goal;
}

Keys joinedKeys(std::initializer_list<Keys> lists) {
  Keys all;
  for (const Keys& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

struct BlockRow {
  const char* name;
  Keys keys;
  std::function<void(const YamlMap&, const Robot&, Step&)> read;
};

const std::array<BlockRow, 6>& blockRows() {
  static const std::array<BlockRow, 6> kRows{
      BlockRow{
          "move_absolute",
          joinedKeys({kCommon, kMotion, {"movement_command", "target_position", "robot_pose"}, kAtTarget}),
          moveAbsolute},
      BlockRow{"move_relative",
               joinedKeys({kCommon, kMotion, {"movement_command", "target_position"}, kAtTarget}),
               moveRelative},
      BlockRow{"move_circle",
               joinedKeys({kCommon, kMotion, {"arc_point", "end_point", "arc_angle"}, kAtTarget}),
               moveCircle},
      BlockRow{"change_base", joinedKeys({kCommon, {"base"}}), changeBase},
      BlockRow{"change_tcp", joinedKeys({kCommon, {"tcp", "weight", "moment_of_inertia", "mass_center"}}),
               changeTcp},
      BlockRow{"script", joinedKeys({kCommon, {"script"}, kAtTarget}), script}};
  return kRows;
}

const BlockRow& rowOf(const YAML::Node& node) {
  const auto& rows = blockRows();
  const YAML::Node block = node.IsMap() ? node["block"] : YAML::Node(YAML::NodeType::Undefined);
  if (!block.IsDefined()) return rows.front();
  YamlNames names;
  for (std::size_t i = 0; i < rows.size(); ++i) names.emplace_back(rows[i].name, static_cast<int>(i));
  return rows[static_cast<std::size_t>(files::toNamed(block, "block", names))];
}

/// Keys that the goals of the blocks have, and steps have not.
void refuseProjectNames(const YAML::Node& node) {
  if (!node.IsMap()) return;
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (key != "base_name" && key != "tcp_name") continue;
    const std::string right = key.substr(0, key.find('_'));
    refuseAt(entry.first.Mark(),
             {key, "names a frame of the project", right + ": [x, y, z, rx, ry, rz]",
              fmt::format(
                  "write its value as {}: the value of a name in the project is unknown here, and can change",
                  right)});
  }
}

}  // namespace

files::YamlMap mapOf(const YAML::Node& node) {
  const BlockRow& row = rowOf(node);
  return YamlMap(node, fmt::format("a {} step", row.name).c_str(), row.keys);
}

void takeGoal(const YAML::Node& node, const Robot& robot, Step& step) {
  // First, as the other keys are known by the one that says the block.
  if (node.IsMap()) files::requireOwnKeys(node, "a step");
  files::refuseRetiredKey(node);
  refuseProjectNames(node);
  rowOf(node).read(mapOf(node), robot, step);
}

}  // namespace cobot_command::cell
