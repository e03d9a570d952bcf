#include "reading/robot_reading.h"

#include "reading/names.h"
#include "reading/shape_reading.h"
#include <fmt/format.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

constexpr std::size_t kMostStations = 256;

std::string modelIn(const YamlMap& map) {
  std::string model = map.text("model");
  const auto& known = arm::ArmModel::knownNames();
  if (std::find(known.begin(), known.end(), model) == known.end()) {
    refuseUnknown(map.required("model").Mark(), "model", model, "model", known);
  }
  return model;
}

Station toStation(const std::string& name, const YAML::Node& node, const arm::ArmModel& arm,
                  const FaultList& faults) {
  const auto values = coordinates(node, "", arm::kJointCount);
  Station station;
  station.name = name;
  station.place = placeOf(faults, node.Mark());
  std::copy(values.begin(), values.end(), station.degrees.begin());
  station.joints = arm::toJointVector(station.degrees);
  const int outside = arm.firstJointOutsideLimits(station.joints);
  if (outside >= 0) {
    const auto joint = static_cast<std::size_t>(outside);
    const arm::JointLimit& limit = arm.limits()[joint];
    refuseAt(node[joint].Mark(),
             {fmt::format("[{}]", joint),
              fmt::format("is {} deg for J{} of a {}", values[joint], joint + 1, arm.name()),
              fmt::format("{:.6g} to {:.6g} deg", radToDeg(limit.lower), radToDeg(limit.upper)), ""});
  }
  return station;
}

}  // namespace

Robot toRobot(const std::string& name, const YAML::Node& node, const FaultList& faults) {
  const YamlMap map(node, "a robot", {"model", "namespace", "base", "home", "holds", "tcp", "tool"});
  Robot robot;
  robot.name = name;
  robot.place = placeOf(faults, node.Mark());
  robot.model = modelIn(map);
  robot.name_space = map.has("namespace") ? nameSpaceIn(map, "namespace") : name;
  robot.base = toPose(map.required("base"), "base");
  robot.home = nameIn(map, "home");
  if (map.has("holds")) robot.holds = map.truth("holds");
  if (map.has("tcp")) robot.tcp = frameIn(map, "tcp", "TCP");
  if (map.has("tool")) robot.tool = toShapes(map.required("tool"), "tool");
  return robot;
}

void readStations(const YAML::Node& node, const std::string& field, Robot& robot, FaultList& faults) {
  const auto arm = arm::ArmModel::named(robot.model);
  if (!arm) return;  // told by its robot
  forEachName(node, field, kMostStations, faults, [&](const std::string& name, const YAML::Node& value) {
    if (find(robot.stations, name) == nullptr) robot.stations.push_back(toStation(name, value, *arm, faults));
  });
  sortByName(robot.stations);
}

void checkHome(const YAML::Node& map, const Robot& robot) {
  if (find(robot.stations, robot.home) != nullptr) return;
  refuseUnknown(map["home"].Mark(), "home", robot.home, "station of the robot", namesOf(robot.stations));
}

}  // namespace cobot_command::cell
