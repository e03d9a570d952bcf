// Problems of robots and zones, as programs of a cell give them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/automata/problem.h"

namespace cobot_command::test_support {

/// "g W", "b Z1", "r W", "u Z1", ...: one cycle of a robot from home to home.
using Cycle = std::vector<std::string>;

inline automata::Problem problemOf(const std::string& name,
                                   const std::vector<std::pair<std::string, Cycle>>& robots) {
  using namespace automata;
  Problem problem;
  problem.name = name;
  struct Use {
    EventIndex event;
    std::size_t robot;
    bool books;
  };
  std::map<std::string, std::vector<Use>> zones;
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    Automaton plant;
    plant.name = robots[robot].first;
    plant.marked = {0};
    const Cycle& cycle = robots[robot].second;
    for (StateIndex place = 0; place < cycle.size(); ++place) {
      const char kind = cycle[place].front();
      const std::string what = cycle[place].substr(2);
      const auto event = static_cast<EventIndex>(problem.events.size());
      problem.events.push_back({fmt::format("{}_{}_{}", plant.name, kind, what), kind == 'g' || kind == 'b'});
      plant.alphabet.push_back(event);
      plant.states.push_back(fmt::format("{}.{}", plant.name, place));
      plant.transitions.push_back({place, event, static_cast<StateIndex>((place + 1) % cycle.size())});
      if (kind == 'b' || kind == 'u') zones[what].push_back({event, robot, kind == 'b'});
    }
    problem.automata.push_back(std::move(plant));
  }
  for (const auto& [zone_name, uses] : zones) {
    Automaton zone;
    zone.name = zone_name;
    zone.kind = Automaton::Kind::Spec;
    zone.states = {"free"};
    zone.marked = {0};
    std::map<std::size_t, StateIndex> owner;
    for (const Use& use : uses) {
      const auto [at, is_new] = owner.emplace(use.robot, static_cast<StateIndex>(zone.states.size()));
      if (is_new) zone.states.push_back(robots[use.robot].first);
      zone.alphabet.push_back(use.event);
      zone.transitions.push_back({use.books ? 0 : at->second, use.event, use.books ? at->second : 0});
    }
    problem.automata.push_back(std::move(zone));
  }
  return problem;
}

inline automata::Problem a1() {
  const Cycle cycle = {"g T1", "b Z", "r T1", "g HOME", "u Z", "r HOME"};
  return problemOf("A1", {{"RA", cycle}, {"RB", cycle}});
}

inline automata::Problem a2a() {
  return problemOf("A2a", {{"RA", {"g W", "b Z1", "b Z2", "r W", "g HOME", "u Z2", "u Z1", "r HOME"}},
                           {"RB", {"g W", "b Z2", "b Z1", "r W", "g HOME", "u Z1", "u Z2", "r HOME"}}});
}

/// A3 for 3: robot i books its own zone, then the next one's.
inline automata::Problem ring(int robots) {
  std::vector<std::pair<std::string, Cycle>> programs;
  for (int robot = 1; robot <= robots; ++robot) {
    const std::string own = fmt::format("Z{}", robot);
    const std::string next = fmt::format("Z{}", robot % robots + 1);
    programs.push_back(
        {fmt::format("R{}", robot),
         {"g W", "b " + own, "b " + next, "r W", "g HOME", "u " + next, "u " + own, "r HOME"}});
  }
  return problemOf(fmt::format("ring of {}", robots), programs);
}

}  // namespace cobot_command::test_support
