// The plant of one robot: a state for each place of its program.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/model/cell_model.h"

namespace cobot_command::cell {

class PlantBuilder {
 public:
  PlantBuilder(CellModel& model, RobotIndex robot, std::vector<std::string>& faults);
  /// Adds plant, places and events to the model.
  void build();

 private:
  using Zones = std::vector<ZoneIndex>;

  [[nodiscard]] bool areIndicesInRange();
  void findHoldsOfStations();
  void addPath(PathIndex path);
  /// False: faults were told.
  [[nodiscard]] bool applyStep(const PathProgram& path, const ZoneStep& step, Zones& held);
  automata::StateIndex addPlace(CellPlace place);
  void addEvent(CellEvent event, bool controllable, automata::StateIndex from, automata::StateIndex to);
  [[nodiscard]] std::string eventName(const CellEvent& event);
  void checkRoundTrips();
  [[nodiscard]] std::vector<bool> reached(std::size_t station, bool forward) const;
  [[nodiscard]] std::string zoneNames(const Zones& zones) const;

  CellModel& model_;
  RobotIndex robot_;
  const RobotProgram& program_;
  std::vector<std::string>& faults_;
  automata::Automaton plant_;
  std::vector<CellPlace> places_;
  std::vector<std::optional<Zones>> held_at_;  ///< by station
  std::map<std::string, int> names_;           ///< how often each was given
};

}  // namespace cobot_command::cell
