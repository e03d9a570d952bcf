#include "model/zone_builder.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

bool has(const std::vector<ZoneIndex>& zones, ZoneIndex zone) {
  return std::find(zones.begin(), zones.end(), zone) != zones.end();
}

}  // namespace

void addZone(CellModel& model, ZoneIndex zone, std::vector<std::string>& faults) {
  automata::Automaton spec;
  spec.name = model.program.zones[zone];
  spec.kind = automata::Automaton::Kind::Spec;
  spec.states = {"free"};
  std::vector<std::optional<RobotIndex>> holders = {std::nullopt};
  std::map<RobotIndex, automata::StateIndex> owner_states;
  const auto owner_state = [&](RobotIndex robot) {
    const auto [at, is_new] =
        owner_states.emplace(robot, static_cast<automata::StateIndex>(spec.states.size()));
    if (is_new) {
      spec.states.push_back(model.program.robots[robot].name);
      holders.emplace_back(robot);
    }
    return at->second;
  };
  for (automata::EventIndex event = 0; event < model.events.size(); ++event) {
    const CellEvent& meaning = model.events[event];
    if (!has(meaning.zones, zone)) continue;
    const automata::StateIndex owner = owner_state(meaning.robot);
    const bool books = meaning.kind == CellEvent::Kind::Book;
    spec.alphabet.push_back(event);
    spec.transitions.push_back({books ? 0 : owner, event, books ? owner : 0});
  }
  for (RobotIndex robot = 0; robot < model.robots(); ++robot) {
    if (!has(model.program.robots[robot].held_at_home, zone)) continue;
    if (spec.initial != 0) {
      faults.push_back(fmt::format("{} and {} both hold {} at home: choose another home for one of them",
                                   spec.states[spec.initial], model.program.robots[robot].name, spec.name));
    }
    spec.initial = owner_state(robot);
  }
  spec.marked = {spec.initial};
  model.holders.push_back(std::move(holders));
  model.problem.automata.push_back(std::move(spec));
}

}  // namespace cobot_command::cell
