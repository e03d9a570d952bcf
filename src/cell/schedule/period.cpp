#include "cobot_command/cell/schedule/period.h"

#include "order_graph.h"

namespace cobot_command::cell {
namespace {

/// The least period of an order, in whole nanoseconds. Precondition: it holds `most`, and not less than
/// nothing.
Duration leastOf(const OrderGraph& order, Duration most) {
  Duration least{};
  while (least < most) {
    const Duration middle = least + (most - least) / 2;
    if (order.holdsPeriod(middle)) {
      most = middle;
    } else {
      least = middle + Duration(1);
    }
  }
  return most;
}

}  // namespace

std::optional<Duration> leastPeriod(const automata::Problem& problem, const std::vector<RobotCycle>& cycles,
                                    std::size_t max_looked_at) {
  const Workload work = workloadOf(problem, cycles);
  // No way in a circle is longer than all times together.
  Duration all{};
  for (const Workload::Robot& robot : work.robots) all += robot.length();
  std::optional<Duration> best;
  const bool is_whole = forEachOrder(work, max_looked_at, [&](const OrderGraph& order) {
    if (best && !order.holdsPeriod(*best - Duration(1))) return;
    if (!order.holdsPeriod(all)) return;
    best = leastOf(order, best.value_or(all));
  });
  if (!is_whole) return std::nullopt;
  return best;
}

}  // namespace cobot_command::cell
