#include "cobot_command/cell/model/rules.h"

#include <algorithm>
#include <utility>

#include "model/part_problem.h"

#include "cobot_command/automata/packed_states.h"
#include "cobot_command/automata/safe_order.h"
#include "cobot_command/automata/undo.h"

namespace cobot_command::cell {

using automata::Composition;
using automata::Decision;

struct Rules::Part {
  Part(const CellModel& model, const automata::PartOfProblem& part, const PartSupervisor& supervisor)
      : policy(supervisor.policy),
        automata(part.automata),
        problem(model, part, supervisor.is_compressed),
        composition(problem.problem()),
        frontier(composition),
        whole(model, part, false),
        order(whole.problem()) {
    for (const automata::Tuple& tuple : supervisor.frontier) frontier.insert(tuple.data());
  }

  /// Whether that event must not lead there, though plants and specs let it.
  [[nodiscard]] bool keepsOutOf(const automata::Tuple& from, const automata::Tuple& to,
                                automata::EventIndex event) const {
    if (policy == Policy::Supervisor) {
      return problem.eventOf(event) && frontier.find(problem.tupleOf(to).data());
    }
    return policy == Policy::SafeOrder &&
           order.decide(whole.tupleOf(from), *whole.eventOf(event)).verdict == Decision::Verdict::WouldBlock;
  }

  Policy policy;
  std::vector<std::size_t> automata;
  PartProblem problem;
  Composition composition;
  automata::PackedStates frontier;
  PartProblem whole;
  /// Of supervisors too: it says who waits for whom.
  automata::SafeOrder order;
};

Rules::Rules(CellModel model, const std::vector<PartSupervisor>& parts, Policy policy)
    : model_(std::move(model)),
      policy_(policy),
      composition_(model_.problem,
                   policy == Policy::None ? Composition::Part::Plants : Composition::Part::All),
      undo_(model_.problem),
      part_of_event_(model_.events.size(), 0),
      part_of_robot_(model_.robots(), 0) {
  const auto problems = automata::independentParts(model_.problem);
  for (const PartSupervisor& supervisor : parts) {
    const auto part = std::find_if(problems.begin(), problems.end(),
                                   [&](const auto& one) { return one.automata == supervisor.automata; });
    for (const automata::EventIndex event : part->events) part_of_event_[event] = parts_.size();
    for (const std::size_t automaton : part->automata) {
      if (automaton < part_of_robot_.size()) part_of_robot_[automaton] = parts_.size();
    }
    parts_.push_back(std::make_unique<Part>(model_, *part, supervisor));
  }
}

Rules::~Rules() = default;
Rules::Rules(Rules&&) noexcept = default;

Decision Rules::decide(const automata::Tuple& state, automata::EventIndex event) const {
  using Verdict = Decision::Verdict;
  if (event >= model_.events.size()) return {};
  const bool is_controllable = composition_.isControllable(event);
  Decision decision;
  decision.next.resize(state.size());
  switch (composition_.step(state.data(), event, decision.next.data())) {
    case Composition::Step::NotInPlants:
      return {Verdict::NotInPlants, composition_.blockerOf(state.data(), event), {}};
    case Composition::Step::BlockedBySpec:
      return {is_controllable ? Verdict::SpecBlocks : Verdict::BreaksSpec,
              composition_.blockerOf(state.data(), event),
              {}};
    case Composition::Step::Possible:
      break;
  }
  decision.verdict = Verdict::Granted;
  if (policy_ != Policy::None && parts_[part_of_event_[event]]->keepsOutOf(state, decision.next, event)) {
    decision.verdict = is_controllable ? Verdict::WouldBlock : Verdict::BreaksSpec;
  }
  return decision;
}

std::optional<automata::Tuple> Rules::undone(const automata::Tuple& state, automata::EventIndex event) const {
  if (event >= model_.events.size() || !composition_.isControllable(event)) return std::nullopt;
  return undo_.before(state, event);
}

std::vector<RobotIndex> Rules::stuckIn(const automata::Tuple& state) const {
  std::vector<RobotIndex> stuck;
  for (const auto& part : parts_) {
    const auto home = part->order.orderHome(part->whole.tupleOf(state));
    std::vector<bool> comes_home(part->automata.size(), false);
    for (const std::size_t automaton : home) comes_home[automaton] = true;
    for (std::size_t automaton = 0; automaton < part->automata.size(); ++automaton) {
      if (!comes_home[automaton] && part->automata[automaton] < model_.robots()) {
        stuck.push_back(part->automata[automaton]);
      }
    }
  }
  return stuck;
}

std::optional<Rules::Intrusion> Rules::intrusionIn(const automata::Tuple& state) const {
  for (RobotIndex robot = 0; robot < model_.robots(); ++robot) {
    if (const auto intrusion = intrusionOf(robot, state)) return intrusion;
  }
  return std::nullopt;
}

/// Along all that it can do from its place and nobody can refuse.
std::optional<Rules::Intrusion> Rules::intrusionOf(RobotIndex robot, const automata::Tuple& state) const {
  const automata::Automaton& plant = model_.problem.automata[robot];
  std::vector<automata::StateIndex> open = {state[robot]};
  for (std::size_t at = 0; at < open.size(); ++at) {
    for (const automata::Transition& step : plant.transitions) {
      if (step.from != open[at] || composition_.isControllable(step.event)) continue;
      const CellEvent& event = model_.events[step.event];
      for (const ZoneIndex zone : event.zones) {
        const auto holder = model_.holder(zone, state[model_.automatonOf(zone)]);
        const bool intrudes = event.kind == CellEvent::Kind::Book && holder && *holder != robot;
        if (intrudes) return Intrusion{robot, zone, *holder};
      }
      if (std::find(open.begin(), open.end(), step.to) == open.end()) open.push_back(step.to);
    }
  }
  return std::nullopt;
}

std::vector<RobotIndex> Rules::aheadOf(const automata::Tuple& state, RobotIndex robot) const {
  const Part& part = *parts_[part_of_robot_[robot]];
  const auto at = std::find(part.automata.begin(), part.automata.end(), robot);
  std::vector<RobotIndex> ahead;
  for (const std::size_t automaton :
       part.order.aheadOf(part.whole.tupleOf(state), static_cast<std::size_t>(at - part.automata.begin()))) {
    ahead.push_back(part.automata[automaton]);
  }
  return ahead;
}

}  // namespace cobot_command::cell
