// What has to hold of whole programs: ends at stations, a graph that comes home, and at each station the same
// frames and the same parts, whichever way the robot came.
#pragma once

#include <map>
#include <string>

#include "checks/fault_list.h"
#include "checks/step_checks.h"

namespace cobot_command::cell {

/// Of a path by itself, whose steps are right each by itself: that it has steps, that the last motion does
/// not blend, and that it ends at the joints of its station where its last motion tells them. Where only a
/// plan knows the end, the planning of the cell checks it.
void checkPath(const Path& path, const Robot& robot, const std::string& field, FaultList& faults);

/// Of a program whose paths are right each by itself; `place`: of the program. The frames that are active at
/// each station; not all of them where there are faults.
std::map<std::string, ActiveFrames> checkProgram(const Robot& robot, const std::vector<Part>& parts,
                                                 const Place& place, const std::string& field,
                                                 FaultList& faults);

}  // namespace cobot_command::cell
