#include "workload.h"

#include <map>
#include <utility>

namespace cobot_command::cell {
namespace {

using automata::Automaton;
using automata::EventIndex;
using automata::Problem;
using automata::StateIndex;
using automata::Transition;

constexpr std::size_t kNobody = ~std::size_t{0};

std::vector<std::size_t> plantsOfEvents(const Problem& problem) {
  std::vector<std::size_t> plant(problem.events.size(), kNobody);
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    if (problem.automata[index].kind != Automaton::Kind::Plant) continue;
    for (const EventIndex event : problem.automata[index].alphabet) plant[event] = index;
  }
  return plant;
}

/// A spec that one plant holds at a time: one state is free, in each other one a single plant has the say.
class ZoneSpec {
 public:
  ZoneSpec(const Automaton& automaton, const std::vector<std::size_t>& plant_of_event)
      : automaton_(automaton), holders_(automaton.states.size(), kNobody) {
    std::vector<bool> is_free(automaton.states.size(), false);
    for (const Transition& transition : automaton.transitions) {
      std::size_t& known = holders_[transition.from];
      const std::size_t plant = plant_of_event[transition.event];
      if (known != kNobody && known != plant) is_free[transition.from] = true;
      known = plant;
      next_[{transition.from, transition.event}] = transition.to;
    }
    std::size_t free_states = 0;
    for (StateIndex state = 0; state < holders_.size(); ++state) {
      if (is_free[state]) holders_[state] = kNobody;
      if (holders_[state] != kNobody) continue;
      free_ = state;
      ++free_states;
    }
    is_zone_ = free_states == 1 && is_free[free_];
    for (const Transition& transition : automaton.transitions) {
      if (!goesAsInZone(transition, plant_of_event[transition.event])) is_zone_ = false;
    }
  }

  [[nodiscard]] bool isZone() const { return is_zone_; }

  void addHolds(std::size_t robot, const Workload::Robot& cycle, std::vector<CycleHold>& holds) const {
    StateIndex state = holders_[automaton_.initial] == cycle.plant ? automaton_.initial : free_;
    std::optional<CycleHold> open;
    std::optional<std::size_t> decision;
    if (state != free_) open = CycleHold{robot, std::nullopt, std::nullopt, std::nullopt};
    for (std::size_t index = 0; index < cycle.size(); ++index) {
      if (!cycle.is_report[index]) decision = index;
      const auto next = next_.find({state, cycle.events[index]});
      if (next == next_.end()) continue;
      const bool was_free = std::exchange(state, next->second) == free_;
      if (was_free) {
        const bool is_decided_before = !holds.empty() && holds.back().robot == robot && decision &&
                                       holds.back().booking && *decision <= *holds.back().booking;
        open = CycleHold{robot, index, is_decided_before ? std::nullopt : decision, std::nullopt};
      } else if (state == free_) {
        open->release = index;
        holds.push_back(*std::exchange(open, std::nullopt));
      }
    }
    if (open) holds.push_back(*open);
  }

 private:
  [[nodiscard]] bool goesAsInZone(const Transition& transition, std::size_t plant) const {
    const std::size_t holder = holders_[transition.to];
    if (transition.from == free_) return holder == plant;
    return holder == plant || transition.to == free_;
  }

  const Automaton& automaton_;
  std::vector<std::size_t> holders_;
  std::map<std::pair<StateIndex, EventIndex>, StateIndex> next_;
  StateIndex free_ = 0;
  bool is_zone_ = false;
};

Workload::Robot robotOf(const Problem& problem, const RobotCycle& cycle) {
  Workload::Robot robot;
  robot.plant = cycle.robot;
  Duration alone{};
  for (const TimedEvent& event : cycle.events) {
    alone += event.after;
    robot.events.push_back(event.event);
    robot.is_report.push_back(!problem.events[event.event].controllable);
    robot.after.push_back(event.after);
    robot.alone.push_back(alone);
  }
  return robot;
}

}  // namespace

Workload workloadOf(const Problem& problem, const std::vector<RobotCycle>& cycles) {
  Workload work;
  for (const RobotCycle& cycle : cycles) work.robots.push_back(robotOf(problem, cycle));
  const auto plant_of_event = plantsOfEvents(problem);
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    if (problem.automata[index].kind != Automaton::Kind::Spec) continue;
    const ZoneSpec spec(problem.automata[index], plant_of_event);
    if (!spec.isZone()) continue;
    Workload::Zone zone{index, {}};
    for (std::size_t robot = 0; robot < work.robots.size(); ++robot) {
      spec.addHolds(robot, work.robots[robot], zone.holds);
    }
    work.zones.push_back(std::move(zone));
  }
  return work;
}

}  // namespace cobot_command::cell
