#include "cobot_command/cell/model/cell_model.h"

#include "model/plant_builder.h"
#include "model/zone_builder.h"

namespace cobot_command::cell {

std::optional<RobotIndex> CellModel::holder(ZoneIndex zone, automata::StateIndex state) const {
  return holders[zone][state];
}

automata::Holds CellModel::holds() const {
  automata::Holds holds(problem.automata.size());
  for (RobotIndex robot = 0; robot < robots(); ++robot) {
    for (const CellPlace& place : places[robot]) holds[robot].push_back(place.holds);
  }
  return holds;
}

Result<CellModel, std::vector<std::string>> modelOf(const CellProgram& program) {
  CellModel model;
  model.program = program;
  model.problem.name = program.name;
  std::vector<std::string> faults;
  for (RobotIndex robot = 0; robot < program.robots.size(); ++robot) {
    PlantBuilder(model, robot, faults).build();
  }
  if (!faults.empty()) return refuse(faults);
  for (ZoneIndex zone = 0; zone < program.zones.size(); ++zone) addZone(model, zone, faults);
  if (faults.empty()) faults = automata::faultsOf(model.problem);
  if (!faults.empty()) return refuse(faults);
  return model;
}

}  // namespace cobot_command::cell
