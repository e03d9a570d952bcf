// Poses and shapes of cell files: mm and degrees → SI.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/cell/bodies/shape.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::cell {

// They throw a YamlFault.

/// A list of so many numbers [mm, deg], each no larger than any arm of the family could mean.
[[nodiscard]] std::vector<double> coordinates(const YAML::Node& node, const std::string& field,
                                              std::size_t count);
/// [x, y, z, rx, ry, rz]; or {position: [x, y, z], quaternion: [x, y, z, w]}, or {position, rotation: [three
/// rows]}, which have to be rotations.
[[nodiscard]] arm::Pose toPose(const YAML::Node& node, const std::string& field);
/// That of `key`; the identity where it is not there.
[[nodiscard]] arm::Pose poseIn(const files::YamlMap& map, const char* key);
/// A base or TCP of the controller [mm, deg], by value: six numbers, as they stand, or as toPose(). `kind`:
/// "base" or "TCP", for errors.
[[nodiscard]] blocks::SixValues frameIn(const files::YamlMap& map, const char* key, const char* kind);
/// Above 0 [mm] → [m].
[[nodiscard]] double lengthIn(const files::YamlMap& map, const char* key);
/// A list of shapes.
[[nodiscard]] std::vector<Shape> toShapes(const YAML::Node& node, const std::string& field);

}  // namespace cobot_command::cell
