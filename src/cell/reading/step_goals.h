// The goal of a step by its block: one table of blocks with the keys that their steps have.
#pragma once

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::cell {

/// The goal that `node`, a step of that robot's program, describes, and the station that it names where it
/// needs a pose (Step::at). Throws a YamlFault; where a key is unknown it tells those of the step's block.
void takeGoal(const YAML::Node& node, const Robot& robot, Step& step);

/// Of a step whose goal was taken: the map with all its keys.
[[nodiscard]] files::YamlMap mapOf(const YAML::Node& node);

}  // namespace cobot_command::cell
