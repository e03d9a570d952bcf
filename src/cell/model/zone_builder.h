// The spec of one zone: free, or held by one robot.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_model.h"

namespace cobot_command::cell {

/// Precondition: all plants are in the model.
void addZone(CellModel& model, ZoneIndex zone, std::vector<std::string>& faults);

}  // namespace cobot_command::cell
