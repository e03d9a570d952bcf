// Best-first search for the shortest schedule: states of the supervisor with the times of the robots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

#include "bound.h"
#include "search_states.h"

#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {

/// One event of a schedule, by robot of the workload.
struct Move {
  std::size_t robot = 0;
  Duration at{};
};

class Search {
 public:
  /// The work has to live longer.
  Search(const Workload& work, Rule rule, const automata::Tuple& initial);

  /// To the end, or to a limit.
  void run(const ScheduleLimits& limits);

  [[nodiscard]] bool hasFound() const { return best_ != kNone; }
  /// Behind run(): all has been looked at, and no limit was in the way.
  [[nodiscard]] bool isExhausted() const { return open_.empty(); }
  /// Of the best one, in the order in which they happen. Precondition: hasFound().
  [[nodiscard]] std::vector<Move> moves() const;
  /// Behind run(): no schedule is shorter.
  [[nodiscard]] Duration bound() const;
  [[nodiscard]] std::size_t expanded() const { return expanded_; }

 private:
  using Number = std::uint32_t;
  static constexpr Number kNone = ~Number{0};
  struct Entry {
    SearchStates::Number state = 0;
    Number parent = kNone;
    std::uint32_t robot = 0;  ///< that made the step from the parent
    std::uint32_t depth = 0;
    bool is_dominated = false;
    Duration bound{};
  };
  struct Open {
    Duration bound{};
    std::uint32_t depth = 0;
    Number entry = 0;
    bool operator<(const Open& other) const;
  };

  [[nodiscard]] const Duration* times(Number entry) const { return times_.data() + entry * robots_; }
  [[nodiscard]] bool isComplete(Number entry) const { return entries_[entry].depth == all_events_; }
  [[nodiscard]] Duration makespanOf(Number entry) const;
  [[nodiscard]] bool isWorthLookingAt(const Open& open) const;
  [[nodiscard]] bool isDominated(const Entry& entry, const std::vector<Duration>& times);
  Number add(const Entry& entry, const std::vector<Duration>& times);
  void expand(Number from);
  void dive(Number from);
  void findSteps(Number from);

  const Workload& work_;
  Bound bound_;
  SearchStates states_;
  std::size_t robots_;
  std::uint32_t all_events_ = 0;
  std::vector<Entry> entries_;
  std::vector<Duration> times_;  ///< of the last event of each robot, by entry
  std::vector<std::vector<Number>> entries_of_state_;
  std::priority_queue<Open> open_;
  Number best_ = kNone;
  std::size_t expanded_ = 0;

  /// What findSteps() has found: entries that are not added yet, each with its times.
  struct Step {
    Entry entry;
    std::vector<Duration> times;
  };
  std::vector<Step> steps_;
};

}  // namespace cobot_command::cell
