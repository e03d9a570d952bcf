// Which event has to wait for which: along the cycles, and from the release of a zone to its next booking.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "workload.h"

#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class OrderGraph {
 public:
  /// The cycles alone. The work has to live longer.
  explicit OrderGraph(const Workload& work);

  /// On one zone: each booking behind the release in front of it.
  void addOrder(const std::vector<const CycleHold*>& order);
  /// Takes the order away that was added last.
  void removeOrder();

  /// Robots wait for each other in a circle.
  [[nodiscard]] bool isCircular() const;
  /// All robots can make one cycle each in that time, again and again.
  [[nodiscard]] bool holdsPeriod(Duration period) const;

 private:
  /// `to` is no earlier than `from`, `cycles` cycles before, and `least` behind it.
  struct Edge {
    std::size_t from = 0;
    std::size_t to = 0;
    Duration least{};
    int cycles = 0;
  };

  [[nodiscard]] std::size_t nodeOf(const CycleHold& hold, std::size_t event) const {
    return first_nodes_[hold.robot] + event;
  }
  void addCycle(const Workload::Robot& robot, std::size_t first);

  std::vector<std::size_t> first_nodes_;  ///< by robot
  std::size_t nodes_ = 0;
  std::vector<Edge> edges_;
  std::vector<Edge>
      reports_;  ///< those that keep reports from being late: backward, so in no circle of waiting
  std::vector<std::size_t> added_;  ///< how many edges there were before each order
};

/// All orders on all zones that are not circular. False: more had to be looked at than was allowed, and the
/// rest was not visited.
[[nodiscard]] bool forEachOrder(const Workload& work, std::size_t max_looked_at,
                                const std::function<void(const OrderGraph&)>& visit);

}  // namespace cobot_command::cell
