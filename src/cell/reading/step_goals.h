// The goal of a step by its block: one table of blocks with the keys that their steps have.
#pragma once

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::cell {

/// The goal that `node`, a step of that robot's program, describes. Throws a YamlFault; where a key is
/// unknown it tells those of the step's block.
[[nodiscard]] StepGoal toGoal(const YAML::Node& node, const Robot& robot);

/// Of a step that toGoal() has read: the map with all its keys.
[[nodiscard]] files::YamlMap mapOf(const YAML::Node& node);

}  // namespace cobot_command::cell
