#include "cobot_command/cell/schedule/zone_orders.h"

#include <limits>

#include "order_graph.h"

namespace cobot_command::cell {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t one, std::uint64_t other) {
  return other != 0 && one > kMost / other ? kMost : one * other;
}

/// Ways to choose the places of `part` among `all`.
std::uint64_t choices(std::uint64_t all, std::uint64_t part) {
  std::uint64_t ways = 1;
  for (std::uint64_t index = 1; index <= part; ++index) {
    ways = product(ways, all - part + index);
    if (ways == kMost) return kMost;
    ways /= index;
  }
  return ways;
}

/// Of the holds that are neither first nor last anyway, those of a robot in their own order.
std::uint64_t ordersOf(const Workload::Zone& zone, std::size_t robots) {
  std::vector<std::uint64_t> free_holds(robots, 0);
  for (const CycleHold& hold : zone.holds) {
    if (hold.booking && hold.release) ++free_holds[hold.robot];
  }
  std::uint64_t orders = 1;
  std::uint64_t all = 0;
  for (const std::uint64_t holds : free_holds) {
    all += holds;
    orders = product(orders, choices(all, holds));
  }
  return orders;
}

}  // namespace

ZoneOrderCounts countZoneOrders(const automata::Problem& problem, const std::vector<RobotCycle>& cycles,
                                std::size_t max_looked_at) {
  const Workload work = workloadOf(problem, cycles);
  ZoneOrderCounts counts;
  for (const Workload::Zone& zone : work.zones) {
    counts.orders = product(counts.orders, ordersOf(zone, work.robots.size()));
  }
  std::uint64_t good = 0;
  const bool is_whole = forEachOrder(work, max_looked_at, [&](const OrderGraph&) { ++good; });
  if (is_whole && counts.orders != kMost) counts.circular = counts.orders - good;
  return counts;
}

}  // namespace cobot_command::cell
