#include "cobot_command/automata/safe_order.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::automata {
namespace {

constexpr std::size_t kNobody = ~std::size_t{0};

/// By event: the plant that has it; of one that several have, the last.
std::vector<std::size_t> plantsOfEvents(const Problem& problem) {
  std::vector<std::size_t> plant(problem.events.size(), kNobody);
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    if (problem.automata[index].kind != Automaton::Kind::Plant) continue;
    for (const EventIndex event : problem.automata[index].alphabet) plant[event] = index;
  }
  return plant;
}

/// By local state of a zone: the plant that alone can do something about it, so that it holds the zone. Where
/// several can, the zone is free.
std::vector<std::size_t> holdersOf(const Automaton& zone, const std::vector<std::size_t>& plant_of_event) {
  std::vector<std::size_t> holder(zone.states.size(), kNobody);
  std::vector<bool> is_shared(zone.states.size(), false);
  for (const Transition& transition : zone.transitions) {
    std::size_t& known = holder[transition.from];
    if (known != kNobody && known != plant_of_event[transition.event]) is_shared[transition.from] = true;
    known = plant_of_event[transition.event];
  }
  for (std::size_t state = 0; state < holder.size(); ++state) {
    if (is_shared[state]) holder[state] = kNobody;
  }
  return holder;
}

}  // namespace

/// What bringing home needs again and again.
struct SafeOrder::Scratch {
  std::vector<bool> seen;         ///< by place
  std::vector<StateIndex> zones;  ///< by place, of each zone of the robot
  std::vector<StateIndex> open;   ///< places
  Tuple next;
};

std::vector<std::string> SafeOrder::objectionsTo(const Problem& problem) {
  std::vector<std::string> objections;
  std::vector<std::size_t> plants(problem.events.size(), 0);
  for (const Automaton& automaton : problem.automata) {
    if (automaton.kind != Automaton::Kind::Plant) continue;
    for (const EventIndex event : automaton.alphabet) {
      if (++plants[event] == 2) {
        objections.push_back(
            fmt::format("\"{}\" belongs to several plants: each robot must have its own events",
                        problem.events[event].name));
      }
    }
  }
  const auto plant_of_event = plantsOfEvents(problem);
  for (const Automaton& zone : problem.automata) {
    if (zone.kind != Automaton::Kind::Spec) continue;
    const auto holder = holdersOf(zone, plant_of_event);
    for (const Transition& transition : zone.transitions) {
      if (problem.events[transition.event].controllable || holder[transition.from] != kNobody ||
          holder[transition.to] == kNobody) {
        continue;
      }
      objections.push_back(fmt::format("\"{}\" takes {} and is uncontrollable: it cannot be made to wait",
                                       problem.events[transition.event].name, zone.name));
    }
  }
  return objections;
}

SafeOrder::SafeOrder(Problem problem, Claim claim)
    : problem_(std::move(problem)),
      claim_(claim),
      composition_(problem_),
      takes_zone_(problem_.events.size(), false),
      holder_of_state_(problem_.automata.size()) {
  const auto plant_of_event = plantsOfEvents(problem_);
  std::vector<std::vector<std::size_t>> zones(problem_.automata.size());
  for (std::size_t index = 0; index < problem_.automata.size(); ++index) {
    const Automaton& zone = problem_.automata[index];
    if (zone.kind != Automaton::Kind::Spec) continue;
    holder_of_state_[index] = holdersOf(zone, plant_of_event);
    for (const Transition& transition : zone.transitions) {
      if (holder_of_state_[index][transition.from] == kNobody) takes_zone_[transition.event] = true;
    }
    for (const EventIndex event : zone.alphabet) {
      auto& of_plant = zones[plant_of_event[event]];
      if (of_plant.empty() || of_plant.back() != index) of_plant.push_back(index);
    }
  }
  for (std::size_t index = 0; index < problem_.automata.size(); ++index) {
    const Automaton& plant = problem_.automata[index];
    if (plant.kind != Automaton::Kind::Plant) continue;
    Robot robot{index, std::vector<std::vector<Way>>(plant.states.size()),
                std::vector<bool>(plant.states.size(), false), zones[index]};
    for (const StateIndex place : plant.marked) robot.is_home[place] = true;
    for (const Transition& transition : plant.transitions) {
      robot.ways[transition.from].push_back({transition.event, transition.to});
    }
    robots_.push_back(std::move(robot));
  }
}

std::vector<std::size_t> SafeOrder::orderHome(const Tuple& state) const {
  Tuple after = state;
  Scratch scratch;
  std::vector<std::size_t> order;
  std::vector<bool> is_home(robots_.size(), false);
  for (bool went_on = true; went_on;) {
    went_on = false;
    for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
      if (is_home[robot]) continue;
      if (claim_ == Claim::WholeCycle ? !bringHomeAtOnce(robots_[robot], after)
                                      : !bringHome(robots_[robot], after, scratch)) {
        continue;
      }
      is_home[robot] = went_on = true;
      order.push_back(robots_[robot].automaton);
    }
  }
  return order;
}

bool SafeOrder::bringHome(const Robot& robot, Tuple& state, Scratch& scratch) const {
  const std::size_t zones = robot.zones.size();
  scratch.seen.assign(robot.ways.size(), false);
  scratch.zones.resize(robot.ways.size() * zones);
  scratch.next = state;
  const auto visit = [&](StateIndex place) {
    scratch.seen[place] = true;
    for (std::size_t zone = 0; zone < zones; ++zone) {
      scratch.zones[place * zones + zone] = scratch.next[robot.zones[zone]];
    }
    scratch.open.push_back(place);
  };
  const Tuple before = state;
  scratch.open.clear();
  visit(state[robot.automaton]);
  while (!scratch.open.empty()) {
    const StateIndex place = scratch.open.back();
    scratch.open.pop_back();
    state[robot.automaton] = place;
    for (std::size_t zone = 0; zone < zones; ++zone) {
      state[robot.zones[zone]] = scratch.zones[place * zones + zone];
    }
    if (robot.is_home[place]) return true;
    for (const Way& way : robot.ways[place]) {
      if (scratch.seen[way.to]) continue;
      if (composition_.step(state.data(), way.event, scratch.next.data()) == Composition::Step::Possible) {
        visit(way.to);
      }
    }
  }
  state = before;
  return false;
}

bool SafeOrder::bringHomeAtOnce(const Robot& robot, Tuple& state) const {
  if (robot.is_home[state[robot.automaton]]) return true;
  for (const std::size_t zone : robot.zones) {
    const std::size_t holder = holder_of_state_[zone][state[zone]];
    if (holder != kNobody && holder != robot.automaton) return false;
  }
  const auto home = std::find(robot.is_home.begin(), robot.is_home.end(), true);
  state[robot.automaton] = static_cast<StateIndex>(home - robot.is_home.begin());
  for (const std::size_t zone : robot.zones) state[zone] = problem_.automata[zone].initial;
  return true;
}

const SafeOrder::Robot& SafeOrder::robotOf(std::size_t automaton) const {
  return *std::find_if(robots_.begin(), robots_.end(),
                       [&](const Robot& robot) { return robot.automaton == automaton; });
}

bool SafeOrder::comesHomeBehind(const Tuple& state, std::size_t robot,
                                const std::vector<std::size_t>& others) const {
  Tuple after = state;
  Scratch scratch;
  for (const std::size_t other : others) {
    if (!bringHome(robotOf(other), after, scratch)) return false;
  }
  return bringHome(robotOf(robot), after, scratch);
}

std::vector<std::size_t> SafeOrder::aheadOf(const Tuple& state, std::size_t robot) const {
  std::vector<std::size_t> ahead;
  for (const std::size_t other : orderHome(state)) {
    if (other == robot) break;
    if (!robotOf(other).is_home[state[other]]) ahead.push_back(other);
  }
  if (!comesHomeBehind(state, robot, ahead)) return {};
  for (std::size_t index = ahead.size(); index-- > 0;) {
    std::vector<std::size_t> fewer = ahead;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(index));
    if (comesHomeBehind(state, robot, fewer)) ahead = std::move(fewer);
  }
  return ahead;
}

bool SafeOrder::needsDecision(EventIndex event, const Tuple& state) const {
  if (!composition_.isControllable(event)) return false;
  if (takes_zone_[event]) return true;
  return std::any_of(robots_.begin(), robots_.end(), [&](const Robot& robot) {
    const auto& ways = robot.ways[state[robot.automaton]];
    return ways.size() > 1 &&
           std::any_of(ways.begin(), ways.end(), [&](const Way& way) { return way.event == event; });
  });
}

Decision SafeOrder::decide(const Tuple& state, EventIndex event) const {
  using Verdict = Decision::Verdict;
  if (event >= composition_.events()) return {};
  Decision decision;
  decision.next.resize(state.size());
  switch (composition_.step(state.data(), event, decision.next.data())) {
    case Composition::Step::NotInPlants:
      return {Verdict::NotInPlants, composition_.blockerOf(state.data(), event), {}};
    case Composition::Step::BlockedBySpec:
      return {composition_.isControllable(event) ? Verdict::SpecBlocks : Verdict::BreaksSpec,
              composition_.blockerOf(state.data(), event),
              {}};
    case Composition::Step::Possible:
      break;
  }
  decision.verdict = Verdict::Granted;
  if (needsDecision(event, state) && !isSafe(decision.next)) decision.verdict = Verdict::WouldBlock;
  return decision;
}

}  // namespace cobot_command::automata
