// What robots carry and what stands around them: parts, obstacles and mechanisms of cell files.
#pragma once

#include <vector>

#include "checks/fault_list.h"

namespace cobot_command::cell {

// Faults are collected; `node`: what stands below the key of that name.
[[nodiscard]] std::vector<Part> readParts(const YAML::Node& node, FaultList& faults);
[[nodiscard]] std::vector<Obstacle> readObstacles(const YAML::Node& node, FaultList& faults);
[[nodiscard]] std::vector<Mechanism> readMechanisms(const YAML::Node& node, FaultList& faults);

}  // namespace cobot_command::cell
