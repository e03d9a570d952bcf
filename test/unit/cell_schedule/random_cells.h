// Cells by chance, small enough to try everything.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cell_problems.h"

#include "cobot_command/automata/state_space.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/automata/synthesis.h"
#include "cobot_command/cell/schedule/robot_cycle.h"

namespace cobot_command::cell {

/// None where it is empty.
inline std::optional<automata::Supervisor> supervisorOf(const automata::Problem& problem) {
  const automata::Composition composition(problem);
  const auto space = *automata::StateSpace::explore(composition, 1000000);
  const automata::Synthesis synthesis(space);
  if (synthesis.empty()) return std::nullopt;
  return automata::Supervisor(automata::compile(synthesis, problem));
}

/// The same gaps for all robots, which have no branches.
inline std::vector<RobotCycle> cyclesWithGaps(const automata::Problem& problem,
                                              const std::vector<double>& gaps) {
  std::vector<RobotCycle> cycles;
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    if (problem.automata[index].kind != automata::Automaton::Kind::Plant) continue;
    cycles.push_back(*cycleWithGaps(problem, index, gaps));
  }
  return cycles;
}

inline const std::vector<double> kGapsOfA1 = {2, 3, 0, 3, 2};
inline const std::vector<double> kGapsOfA2a = {2, 1, 3, 0, 3, 1, 2};

struct RandomCell {
  automata::Problem problem;
  std::vector<RobotCycle> cycles;
};

using Chance = std::mt19937;
inline std::size_t below(Chance& chance, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(chance);
}

/// Some zones, each booked and released once, with a go and a report anywhere in between.
inline test_support::Cycle randomCycle(Chance& chance, std::size_t zones) {
  test_support::Cycle cycle;
  for (std::size_t zone = 1; zone <= zones; ++zone) {
    if (below(chance, 4) == 0) continue;
    const auto booking = static_cast<std::ptrdiff_t>(below(chance, cycle.size() + 1));
    cycle.insert(cycle.begin() + booking, "b Z" + std::to_string(zone));
    const auto span = cycle.size() - static_cast<std::size_t>(booking);
    const auto release = booking + 1 + static_cast<std::ptrdiff_t>(below(chance, span));
    cycle.insert(cycle.begin() + release, "u Z" + std::to_string(zone));
  }
  const auto middle = static_cast<std::ptrdiff_t>(below(chance, cycle.size() + 1));
  cycle.insert(cycle.begin() + middle, {"r A", "g B"});
  cycle.insert(cycle.begin(), "g A");
  cycle.push_back("r B");
  return cycle;
}

/// Times are whole seconds from 0 to 3. In one of four cells a booking cannot be kept waiting.
inline RandomCell randomCell(Chance& chance, std::size_t robots, std::size_t zones) {
  std::vector<std::pair<std::string, test_support::Cycle>> programs;
  for (std::size_t robot = 1; robot <= robots; ++robot) {
    programs.emplace_back("R" + std::to_string(robot), randomCycle(chance, zones));
  }
  RandomCell cell{test_support::problemOf("by chance", programs), {}};
  if (below(chance, 4) == 0) {
    auto& event = cell.problem.events[below(chance, cell.problem.events.size())];
    if (event.name.find("_b_") != std::string::npos) event.controllable = false;
  }
  for (std::size_t robot = 0; robot < robots; ++robot) {
    std::vector<double> gaps(programs[robot].second.size() - 1);
    for (double& gap : gaps) gap = static_cast<double>(below(chance, 4));
    cell.cycles.push_back(*cycleWithGaps(cell.problem, robot, gaps));
  }
  return cell;
}

}  // namespace cobot_command::cell
