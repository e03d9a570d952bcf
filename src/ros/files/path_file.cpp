#include "files/path_file.h"

#include <array>

#include "files/named_file.h"
#include <fmt/format.h>

#include "cobot_command/PathPoint.h"
#include "cobot_command/files/yaml_map.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::ros_adapter {
namespace {

using Message = cobot_command::PathPoint;
using files::toNamed;
using files::toNumber;
using files::YamlMap;
using files::YamlNames;

constexpr std::size_t kMaxFileSize = 4 << 20;  // four times a thousand points with all their fields

const YamlNames kMoves = {{"ABSOLUTE", Message::ABSOLUTE}, {"INCREMENTAL", Message::INCREMENTAL}};
const YamlNames kTargets = {
    {"JOINT", Message::JOINT}, {"CARTESIAN", Message::CARTESIAN}, {"HYBRID", Message::HYBRID}};
const YamlNames kInterpolations = {{"PTP", Message::PTP},
                                   {"CP_LINEAR", Message::CP_LINEAR},
                                   {"CP_WRIST", Message::CP_WRIST},
                                   {"CP_CIRCULAR", Message::CP_CIRCULAR}};
const YamlNames kMovedFrames = {{"FLANGE", Message::FLANGE}, {"TOOL", Message::TOOL}};
const YamlNames kReferences = {{"WORLD", Message::WORLD}, {"ROBOT", Message::ROBOT}, {"USER", Message::USER}};
const YamlNames kTerminations = {{"STOP", Message::STOP}, {"BLEND", Message::BLEND}};
const YamlNames kProfiles = {{"S_CURVE", Message::S_CURVE},
                             {"POLY5", Message::POLY5},
                             {"MOD_SINE", Message::MOD_SINE},
                             {"SINE2", Message::SINE2}};
/// With the values of their bits.
const std::array<YamlNames, 3> kPostures = {YamlNames{{"RIGHTY", 0}, {"LEFTY", 2}},
                                            YamlNames{{"BELOW", 0}, {"ABOVE", 4}},
                                            YamlNames{{"NOFLIP", 0}, {"FLIP", 8}}};

template <std::size_t kSize>
void take(const YamlMap& map, const char* key, std::size_t count, std::array<double, kSize>& values) {
  if (!map.has(key)) return;
  const YAML::Node list = map.list(key, count);
  for (std::size_t i = 0; i < count; ++i) values[i] = toNumber(list[i], fmt::format("{}[{}]", key, i));
}

void take(const YamlMap& map, const char* key, double& value) {
  if (map.has(key)) value = map.number(key);
}
void take(const YamlMap& map, const char* key, int& value) {
  if (map.has(key)) value = map.whole(key);
}
void take(const YamlMap& map, const char* key, const YamlNames& names, int& value) {
  if (map.has(key)) value = map.named(key, names);
}

void takeTarget(const YamlMap& map, path::PathPoint& point) {
  take(map, "move_type", kMoves, point.move_type);
  take(map, "target_point_type", kTargets, point.target_type);
  point.interpolation = map.named("interpolation_type", kInterpolations);
  take(map, "pose", point.pose.size(), point.pose);
  take(map, "pose_type", kMovedFrames, point.pose_type);
  take(map, "pose_id", point.pose_id);
  take(map, "ref_frame_type", kReferences, point.ref_frame_type);
  take(map, "ref_frame_id", point.ref_frame_id);
  take(map, "joints", arm::kJointCount, point.joints);
  take(map, "via_pose", 3, point.via_pose);
  if (!map.has("robot_configuration")) return;
  const YAML::Node posture = map.list("robot_configuration", kPostures.size());
  point.robot_configuration = 1;
  for (std::size_t i = 0; i < kPostures.size(); ++i) {
    point.robot_configuration += toNamed(posture[i], fmt::format("robot_configuration[{}]", i), kPostures[i]);
  }
}

void takeDynamics(const YamlMap& map, path::PathPoint& point) {
  take(map, "termination_type", kTerminations, point.termination_type);
  take(map, "command_tolerance", point.command_tolerance);
  take(map, "profile_type", kProfiles, point.profile_type);
  take(map, "speed", point.speed);
  take(map, "acceleration", point.acceleration);
  take(map, "deceleration", point.deceleration);
  take(map, "acceleration_jerk", point.acceleration_jerk);
  take(map, "deceleration_jerk", point.deceleration_jerk);
  take(map, "orientation_speed", point.orientation_speed);
  take(map, "orientation_acceleration", point.orientation_acceleration);
  take(map, "orientation_deceleration", point.orientation_deceleration);
  take(map, "tracking_axis_position", point.tracking_axis_position);
}

/// The field without which its target would be all zeros.
void requireTarget(const YamlMap& map, const path::PathPoint& point) {
  if (!is(point.target_type, path::TargetType::Joint)) static_cast<void>(map.required("pose"));
  if (!is(point.target_type, path::TargetType::Cartesian)) static_cast<void>(map.required("joints"));
  if (is(point.interpolation, path::Interpolation::Circular)) static_cast<void>(map.required("via_pose"));
}

path::PathPoint toPoint(const YAML::Node& node) {
  const YamlMap map(node, "a point",
                    {"name",
                     "move_id",
                     "move_type",
                     "target_point_type",
                     "interpolation_type",
                     "pose",
                     "pose_type",
                     "pose_id",
                     "ref_frame_type",
                     "ref_frame_id",
                     "joints",
                     "via_pose",
                     "termination_type",
                     "command_tolerance",
                     "robot_configuration",
                     "profile_type",
                     "speed",
                     "acceleration",
                     "deceleration",
                     "acceleration_jerk",
                     "deceleration_jerk",
                     "orientation_speed",
                     "orientation_acceleration",
                     "orientation_deceleration",
                     "tracking_axis_position"});
  if (map.has("name")) static_cast<void>(map.text("name"));
  path::PathPoint point;
  take(map, "move_id", point.move_id);
  takeTarget(map, point);
  takeDynamics(map, point);
  requireTarget(map, point);
  return point;
}

PathPoints toPoints(const YAML::Node& document) {
  const YamlMap file(document, "the file", {"points"});
  PathPoints points;
  for (const YAML::Node& node : file.listOf("points", path::kMostPoints, "points")) {
    points.push_back(toPoint(node));
  }
  return points;
}

}  // namespace

Result<PathPoints, std::string> parsePath(const std::string& text, const std::string& name) {
  return files::readYaml<PathPoints>(text, name, toPoints);
}

Result<PathPoints, std::string> readPathFile(const std::string& location) {
  const auto file = readNamedFile("path_file", location, kMaxFileSize);
  if (!file) return refuse(file.error());
  return parsePath(file->text, file->name);
}

}  // namespace cobot_command::ros_adapter
