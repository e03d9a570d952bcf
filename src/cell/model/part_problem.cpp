#include "model/part_problem.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cobot_command/automata/compression.h"

namespace cobot_command::cell {
namespace {

/// Events of the part that let a mechanism go which then enters zones by itself: refusing them is all that
/// keeps it out.
std::vector<automata::EventIndex> lettingGo(const CellModel& model, const automata::PartOfProblem& part) {
  std::vector<automata::EventIndex> events;
  for (automata::EventIndex event = 0; event < part.events.size(); ++event) {
    const CellEvent& meaning = model.events[part.events[event]];
    if (meaning.kind != CellEvent::Kind::Go) continue;
    const auto& steps = model.program.robots[meaning.robot].paths[meaning.path].steps;
    const bool enters_by_itself =
        std::any_of(steps.begin(), steps.end(), [](const ZoneStep& step) { return step.uncontrollable; });
    if (enters_by_itself) events.push_back(event);
  }
  return events;
}

}  // namespace

automata::PartOfProblem partOf(const CellModel& model, const PartSupervisor& supervisor) {
  for (automata::PartOfProblem& part : automata::independentParts(model.problem)) {
    if (part.automata == supervisor.automata) return std::move(part);
  }
  return {};
}

PartProblem::PartProblem(const CellModel& model, const automata::PartOfProblem& part, bool is_compressed)
    : problem_(part.problem), automata_(part.automata), events_(model.events.size()) {
  if (is_compressed) {
    automata::Compressed compressed = automata::compress(part.problem, lettingGo(model, part));
    problem_ = std::move(compressed.problem);
    state_of_ = std::move(compressed.state_of);
    for (automata::EventIndex event = 0; event < compressed.events.size(); ++event) {
      events_[part.events[compressed.events[event]]] = event;
    }
    return;
  }
  for (const automata::Automaton& automaton : problem_.automata) {
    std::vector<automata::StateIndex>& same = state_of_.emplace_back(automaton.states.size());
    std::iota(same.begin(), same.end(), automata::StateIndex{0});
  }
  for (automata::EventIndex event = 0; event < part.events.size(); ++event) {
    events_[part.events[event]] = event;
  }
}

automata::Tuple PartProblem::tupleOf(const automata::Tuple& of_cell) const {
  automata::Tuple tuple(automata_.size());
  for (std::size_t automaton = 0; automaton < tuple.size(); ++automaton) {
    tuple[automaton] = state_of_[automaton][of_cell[automata_[automaton]]];
  }
  return tuple;
}

std::vector<automata::StateIndex> PartProblem::statesOfCell(std::size_t automaton,
                                                            automata::StateIndex state) const {
  std::vector<automata::StateIndex> states;
  const auto& state_of = state_of_[automaton];
  for (automata::StateIndex of_cell = 0; of_cell < state_of.size(); ++of_cell) {
    if (state_of[of_cell] == state) states.push_back(of_cell);
  }
  return states;
}

automata::Holds PartProblem::holds(const CellModel& model) const {
  automata::Holds holds(automata_.size());
  const automata::Holds of_cell = model.holds();
  for (std::size_t automaton = 0; automaton < holds.size(); ++automaton) {
    const auto& of_robot = of_cell[automata_[automaton]];
    if (of_robot.empty()) continue;
    holds[automaton].resize(problem_.automata[automaton].states.size());
    // What is left out changes no zone, so that all places that became one hold the same.
    for (std::size_t place = 0; place < of_robot.size(); ++place) {
      holds[automaton][state_of_[automaton][place]] = of_robot[place];
    }
  }
  return holds;
}

}  // namespace cobot_command::cell
