#include "compaction.h"

#include <algorithm>
#include <utility>

namespace cobot_command::cell {
namespace {

/// Robot and event of its cycle.
struct Place {
  std::size_t robot = 0;
  std::size_t event = 0;
};

/// By robot and event: the releases that it comes behind.
std::vector<std::vector<std::vector<Place>>> releasesBefore(const Workload& work,
                                                            const std::vector<Move>& moves) {
  std::vector<std::vector<std::vector<Place>>> before;
  for (const Workload::Robot& robot : work.robots) before.emplace_back(robot.size());
  for (const auto& holds : holdsInOrder(work, moves)) {
    for (std::size_t index = 1; index < holds.size(); ++index) {
      const CycleHold& hold = holds[index];
      const CycleHold& previous = holds[index - 1];
      if (!hold.decision || !previous.release || hold.robot == previous.robot) continue;
      before[hold.robot][*hold.decision].push_back({previous.robot, *previous.release});
    }
  }
  return before;
}

bool isGranted(const Workload& work, const std::vector<Move>& moves, const Rule& rule,
               automata::Tuple state) {
  std::vector<std::size_t> counts(work.robots.size(), 0);
  for (const Move& move : moves) {
    automata::Decision decision = rule(state, work.robots[move.robot].events[counts[move.robot]++]);
    if (decision.verdict != automata::Decision::Verdict::Granted) return false;
    state = std::move(decision.next);
  }
  return true;
}

}  // namespace

std::vector<std::vector<CycleHold>> holdsInOrder(const Workload& work, const std::vector<Move>& moves) {
  std::vector<std::vector<std::size_t>> ranks(work.robots.size());
  for (std::size_t index = 0; index < moves.size(); ++index) ranks[moves[index].robot].push_back(index + 1);
  const auto rank_of = [&](const CycleHold& hold) {
    return hold.booking ? ranks[hold.robot][*hold.booking] : 0;
  };
  std::vector<std::vector<CycleHold>> orders;
  for (const Workload::Zone& zone : work.zones) {
    orders.push_back(zone.holds);
    std::sort(orders.back().begin(), orders.back().end(),
              [&](const CycleHold& one, const CycleHold& other) { return rank_of(one) < rank_of(other); });
  }
  return orders;
}

std::vector<Move> compacted(const Workload& work, const std::vector<Move>& moves, const Rule& rule,
                            const automata::Tuple& initial) {
  const auto before = releasesBefore(work, moves);
  std::vector<std::vector<Duration>> times(work.robots.size());
  std::vector<Move> earlier;
  for (const Move& move : moves) {
    std::vector<Duration>& mine = times[move.robot];
    const std::size_t event = mine.size();
    Duration at = (event == 0 ? Duration{} : mine.back()) + work.robots[move.robot].after[event];
    for (const Place& release : before[move.robot][event]) {
      at = std::max(at, times[release.robot][release.event]);
    }
    mine.push_back(at);
    earlier.push_back({move.robot, at});
  }
  std::stable_sort(earlier.begin(), earlier.end(),
                   [](const Move& one, const Move& other) { return one.at < other.at; });
  return isGranted(work, earlier, rule, initial) ? earlier : moves;
}

}  // namespace cobot_command::cell
