#include "cobot_command/cell/schedule/robot_cycle.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using automata::Automaton;
using automata::EventIndex;
using automata::Problem;
using automata::StateIndex;
using automata::Transition;
using Faults = std::vector<std::string>;

/// Of all cycles together: far beyond any cell, and far from where sums of times and periods of so many
/// events would no longer fit. [s]
constexpr double kLongest = 1e6;
constexpr std::size_t kMostEvents = 4000;

/// By event: how many plants have it.
std::vector<std::size_t> ownersOf(const Problem& problem) {
  std::vector<std::size_t> owners(problem.events.size(), 0);
  for (const Automaton& automaton : problem.automata) {
    if (automaton.kind != Automaton::Kind::Plant) continue;
    for (const EventIndex event : automaton.alphabet) ++owners[event];
  }
  return owners;
}

std::optional<StateIndex> stepOf(const Automaton& plant, StateIndex from, EventIndex event) {
  for (const Transition& transition : plant.transitions) {
    if (transition.from == from && transition.event == event) return transition.to;
  }
  return std::nullopt;
}

void addFaultsOfWay(const Problem& problem, const RobotCycle& cycle, Faults& faults) {
  const Automaton& plant = problem.automata[cycle.robot];
  const auto owners = ownersOf(problem);
  StateIndex place = plant.initial;
  for (std::size_t index = 0; index < cycle.events.size(); ++index) {
    const TimedEvent& timed = cycle.events[index];
    const std::string where = fmt::format("event {} of the cycle of {}", index + 1, plant.name);
    if (timed.event >= problem.events.size()) {
      return faults.push_back(fmt::format("{} does not exist: there are {} events, the first of them is 0",
                                          where, problem.events.size()));
    }
    const std::string& name = problem.events[timed.event].name;
    if (owners[timed.event] > 1) {
      return faults.push_back(fmt::format(
          "{}: \"{}\" belongs to several plants: each robot must have its own events", where, name));
    }
    if (std::find(plant.alphabet.begin(), plant.alphabet.end(), timed.event) == plant.alphabet.end()) {
      return faults.push_back(fmt::format("{}: \"{}\" is not an event of {}", where, name, plant.name));
    }
    if (timed.after < Duration{}) {
      faults.push_back(fmt::format("{}, \"{}\", is {} s after the event before it: this must not be negative",
                                   where, name, toSeconds(timed.after)));
    }
    const auto next = stepOf(plant, place, timed.event);
    if (!next) {
      return faults.push_back(
          fmt::format("{}: {} cannot execute \"{}\" at {}", where, plant.name, name, plant.states[place]));
    }
    place = *next;
  }
  if (place != plant.initial) {
    faults.push_back(fmt::format("the cycle of {} ends at {}, not at its home {}", plant.name,
                                 plant.states[place], plant.states[plant.initial]));
  }
}

void addFaultsOfCycle(const Problem& problem, const RobotCycle& cycle, Faults& faults) {
  if (cycle.robot >= problem.automata.size()) {
    return faults.push_back(fmt::format("there is no robot {}: there are {} automata, the first of them is 0",
                                        cycle.robot, problem.automata.size()));
  }
  const std::string& name = problem.automata[cycle.robot].name;
  if (problem.automata[cycle.robot].kind != Automaton::Kind::Plant) {
    return faults.push_back(fmt::format("{} is a spec, not a robot", name));
  }
  if (cycle.events.empty()) {
    return faults.push_back(fmt::format("the cycle of {} has no events: leave out a robot that rests", name));
  }
  addFaultsOfWay(problem, cycle, faults);
}

void addFaultsOfSize(const std::vector<RobotCycle>& cycles, Faults& faults) {
  std::size_t events = 0;
  double seconds = 0.0;
  for (const RobotCycle& cycle : cycles) {
    events += cycle.events.size();
    for (const TimedEvent& event : cycle.events) seconds += toSeconds(event.after);
  }
  if (events > kMostEvents) {
    faults.push_back(fmt::format("{} events: at most {} can be scheduled", events, kMostEvents));
  }
  if (seconds > kLongest) {
    faults.push_back(
        fmt::format("all cycles together take {} s: at most {} s can be scheduled", seconds, kLongest));
  }
}

/// The search lets no report come later than it is due. So nobody may lose by an earlier report what would be
/// granted without it: in each spec, what can happen before a report can happen behind it, to the same end.
void addFaultsOfReports(const Problem& problem, const Automaton& spec, Faults& faults) {
  std::map<std::pair<StateIndex, EventIndex>, StateIndex> next;
  std::vector<std::size_t> plant_of(problem.events.size(), 0);
  for (const Transition& step : spec.transitions) next[{step.from, step.event}] = step.to;
  for (std::size_t plant = 0; plant < problem.automata.size(); ++plant) {
    if (problem.automata[plant].kind != Automaton::Kind::Plant) continue;
    for (const EventIndex event : problem.automata[plant].alphabet) plant_of[event] = plant;
  }
  std::set<std::pair<EventIndex, EventIndex>> told;
  for (const Transition& report : spec.transitions) {
    if (problem.events[report.event].controllable) continue;
    for (const Transition& other : spec.transitions) {
      if (other.from != report.from || plant_of[other.event] == plant_of[report.event]) continue;
      const auto before = next.find({other.to, report.event});
      if (before == next.end()) continue;
      const auto behind = next.find({report.to, other.event});
      if (behind != next.end() && behind->second == before->second) continue;
      if (!told.insert({report.event, other.event}).second) continue;
      faults.push_back(
          fmt::format("in {}, the effect of the report \"{}\" differs before and after \"{}\": such reports "
                      "cannot be scheduled",
                      spec.name, problem.events[report.event].name, problem.events[other.event].name));
    }
  }
}

}  // namespace

Faults faultsOfCycles(const Problem& problem, const std::vector<RobotCycle>& cycles) {
  Faults faults;
  if (cycles.empty()) return {"no robot has a cycle: there is nothing to schedule"};
  std::set<std::size_t> robots;
  for (const RobotCycle& cycle : cycles) {
    addFaultsOfCycle(problem, cycle, faults);
    if (robots.insert(cycle.robot).second || cycle.robot >= problem.automata.size()) continue;
    faults.push_back(fmt::format("{} has two cycles", problem.automata[cycle.robot].name));
  }
  addFaultsOfSize(cycles, faults);
  for (const Automaton& automaton : problem.automata) {
    if (automaton.kind == Automaton::Kind::Spec) addFaultsOfReports(problem, automaton, faults);
  }
  return faults;
}

Result<RobotCycle, std::string> cycleWithGaps(const Problem& problem, std::size_t robot,
                                              const std::vector<double>& gaps) {
  if (robot >= problem.automata.size() || problem.automata[robot].kind != Automaton::Kind::Plant) {
    return refuse(fmt::format("automaton {} is not a robot", robot));
  }
  const Automaton& plant = problem.automata[robot];
  std::map<StateIndex, Transition> ways;
  for (const Transition& way : plant.transitions) {
    if (!ways.emplace(way.from, way).second) {
      return refuse(fmt::format("{} has several paths at {}: gaps alone do not determine which one it takes",
                                plant.name, plant.states[way.from]));
    }
  }
  RobotCycle cycle{robot, {}};
  StateIndex place = plant.initial;
  do {
    const auto way = ways.find(place);
    if (way == ways.end() || cycle.events.size() > ways.size()) {
      return refuse(fmt::format("{} has no path home from {}", plant.name, plant.states[place]));
    }
    cycle.events.push_back({way->second.event, Duration{}});
    place = way->second.to;
  } while (place != plant.initial);
  if (gaps.size() + 1 != cycle.events.size()) {
    return refuse(fmt::format("{} has {} events, and so {} gaps between them, but {} are given", plant.name,
                              cycle.events.size(), cycle.events.size() - 1, gaps.size()));
  }
  for (std::size_t index = 0; index < gaps.size(); ++index) {
    if (!(gaps[index] >= 0.0 && gaps[index] <= kLongest)) {
      return refuse(fmt::format("gap {} of {} is {} s: it must be a time from 0 to {} s", index + 1,
                                plant.name, gaps[index], kLongest));
    }
    cycle.events[index + 1].after = fromSeconds(gaps[index]);
  }
  return cycle;
}

}  // namespace cobot_command::cell
