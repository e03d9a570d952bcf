// The shortest schedule by trying everything at every second: neither orders, nor bounds, nor dominance.
//
// For times of whole seconds, for which the shortest schedule is one of whole seconds as well.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "cobot_command/automata/supervisor.h"
#include "cobot_command/cell/schedule/robot_cycle.h"

namespace cobot_command::cell {

class EverySecond {
 public:
  EverySecond(const automata::Supervisor& supervisor, const std::vector<RobotCycle>& cycles)
      : supervisor_(supervisor), cycles_(cycles) {}

  /// In seconds; none: they do not come home.
  [[nodiscard]] std::optional<int> makespan() {
    std::set<State> states = {
        {supervisor_.initial(), std::vector<std::size_t>(cycles_.size(), 0), Elapsed(cycles_.size(), 0)}};
    for (int second = 0; !states.empty() && second < 1000; ++second) {
      reached_.clear();
      for (const State& state : states) happen(state);
      std::set<State> later;
      for (const State& state : reached_) {
        if (isHome(state)) return second;
        if (const auto next = wait(state)) later.insert(*next);
      }
      // Everybody waits for what does not come.
      if (later == states) return std::nullopt;
      states = std::move(later);
    }
    return std::nullopt;
  }

 private:
  using Elapsed = std::vector<int>;
  struct State {
    automata::Tuple tuple;
    std::vector<std::size_t> counts;
    Elapsed elapsed;  ///< since the robot's event before, at most as long as it has to be

    bool operator<(const State& other) const {
      return std::tie(tuple, counts, elapsed) < std::tie(other.tuple, other.counts, other.elapsed);
    }
    bool operator==(const State& other) const { return !(*this < other) && !(other < *this); }
  };

  [[nodiscard]] bool isHome(const State& state) const {
    for (std::size_t robot = 0; robot < cycles_.size(); ++robot) {
      if (state.counts[robot] < cycles_[robot].events.size()) return false;
    }
    return true;
  }
  [[nodiscard]] bool isDue(const State& state, std::size_t robot) const {
    if (state.counts[robot] == cycles_[robot].events.size()) return false;
    const Duration after = cycles_[robot].events[state.counts[robot]].after;
    return std::chrono::seconds(state.elapsed[robot]) >= after;
  }

  /// All that can happen without time going on.
  void happen(const State& state) {
    if (!reached_.insert(state).second) return;
    for (std::size_t robot = 0; robot < cycles_.size(); ++robot) {
      if (!isDue(state, robot)) continue;
      const auto event = cycles_[robot].events[state.counts[robot]].event;
      const automata::Decision decision = supervisor_.decide(state.tuple, event);
      if (decision.verdict != automata::Decision::Verdict::Granted) continue;
      State next = state;
      next.tuple = decision.next;
      ++next.counts[robot];
      next.elapsed[robot] = 0;
      happen(next);
    }
  }

  /// One second; none: a report is due.
  [[nodiscard]] std::optional<State> wait(const State& state) const {
    State next = state;
    for (std::size_t robot = 0; robot < cycles_.size(); ++robot) {
      if (isDue(state, robot)) {
        const auto event = cycles_[robot].events[state.counts[robot]].event;
        if (!supervisor_.compiled().problem.events[event].controllable) return std::nullopt;
      } else if (state.counts[robot] < cycles_[robot].events.size()) {
        ++next.elapsed[robot];
      }
    }
    return next;
  }

  const automata::Supervisor& supervisor_;
  const std::vector<RobotCycle>& cycles_;
  std::set<State> reached_;
};

}  // namespace cobot_command::cell
