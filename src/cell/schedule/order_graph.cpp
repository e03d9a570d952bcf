#include "order_graph.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cobot_command::cell {

OrderGraph::OrderGraph(const Workload& work) {
  for (const Workload::Robot& robot : work.robots) {
    first_nodes_.push_back(nodes_);
    addCycle(robot, nodes_);
    nodes_ += robot.size();
  }
}

void OrderGraph::addCycle(const Workload::Robot& robot, std::size_t first) {
  for (std::size_t event = 0; event < robot.size(); ++event) {
    const bool is_first = event == 0;
    const std::size_t before = first + (is_first ? robot.size() : event) - 1;
    const int cycles = is_first ? 1 : 0;
    edges_.push_back({before, first + event, robot.after[event], cycles});
    if (robot.is_report[event]) reports_.push_back({first + event, before, -robot.after[event], -cycles});
  }
}

void OrderGraph::addOrder(const std::vector<const CycleHold*>& order) {
  added_.push_back(edges_.size());
  for (std::size_t index = 0; index < order.size(); ++index) {
    const bool is_last = index + 1 == order.size();
    const CycleHold& hold = *order[index];
    const CycleHold& next = *order[is_last ? 0 : index + 1];
    if (!hold.release || !next.booking) continue;
    // While another robot holds a zone, a supervisor grants nothing that leads to a booking of it by itself.
    const bool is_same = next.robot == hold.robot;
    const std::size_t behind = is_same ? *next.booking : next.decision.value_or(*next.booking);
    edges_.push_back({nodeOf(hold, *hold.release), nodeOf(next, behind), Duration{}, is_last ? 1 : 0});
  }
}

void OrderGraph::removeOrder() {
  edges_.resize(added_.back());
  added_.pop_back();
}

bool OrderGraph::isCircular() const {
  std::vector<std::size_t> waits_for(nodes_, 0);
  std::vector<std::vector<std::size_t>> behind(nodes_);
  for (const Edge& edge : edges_) {
    if (edge.cycles != 0) continue;
    ++waits_for[edge.to];
    behind[edge.from].push_back(edge.to);
  }
  std::vector<std::size_t> open;
  for (std::size_t node = 0; node < nodes_; ++node) {
    if (waits_for[node] == 0) open.push_back(node);
  }
  std::size_t done = 0;
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    ++done;
    for (const std::size_t next : behind[node]) {
      if (--waits_for[next] == 0) open.push_back(next);
    }
  }
  return done < nodes_;
}

/// The longest ways to all events, each cycle back worth a period. One with more edges than there are events,
/// or longer than all edges together, has gone in a circle that is longer than its periods.
bool OrderGraph::holdsPeriod(Duration period) const {
  const auto length_of = [&](const Edge& edge) { return edge.least - period * edge.cycles; };
  Duration all{};
  for (const Edge& edge : edges_) all += std::max(length_of(edge), Duration{});
  for (const Edge& edge : reports_) all += std::max(length_of(edge), Duration{});
  std::vector<Duration> earliest(nodes_, Duration{});
  bool has_changed = true;
  const auto push = [&](const Edge& edge) {
    const Duration at = earliest[edge.from] + length_of(edge);
    if (at <= earliest[edge.to]) return true;
    earliest[edge.to] = at;
    has_changed = true;
    return at <= all;
  };
  for (std::size_t round = 0; has_changed; ++round) {
    if (round > nodes_) return false;
    has_changed = false;
    if (!std::all_of(edges_.begin(), edges_.end(), push)) return false;
    if (!std::all_of(reports_.begin(), reports_.end(), push)) return false;
  }
  return true;
}

namespace {

/// One zone after the other, one hold after the other.
class OrderWalk {
 public:
  OrderWalk(const Workload& work, std::size_t max_looked_at, std::function<void(const OrderGraph&)> visit)
      : work_(work), left_(max_looked_at), visit_(std::move(visit)), graph_(work) {}

  bool run() {
    walkZone(0);
    return !is_cut_;
  }

 private:
  struct Picked {
    std::vector<const CycleHold*> order;
    std::vector<std::size_t> next;  ///< by robot: index of its next hold
    std::vector<std::vector<const CycleHold*>> holds;
  };

  void walkZone(std::size_t zone) {
    if (zone == work_.zones.size()) return visit_(graph_);
    Picked picked;
    picked.next.resize(work_.robots.size(), 0);
    picked.holds.resize(work_.robots.size());
    for (const CycleHold& hold : work_.zones[zone].holds) picked.holds[hold.robot].push_back(&hold);
    pick(zone, picked);
  }

  /// What is held from the start is first, what is held to the end is last.
  void pick(std::size_t zone, Picked& picked) {
    const std::size_t all = work_.zones[zone].holds.size();
    if (picked.order.size() == all) return tryOrder(zone, picked.order);
    for (std::size_t robot = 0; robot < picked.next.size() && !is_cut_; ++robot) {
      if (picked.next[robot] == picked.holds[robot].size()) continue;
      const CycleHold* hold = picked.holds[robot][picked.next[robot]];
      if (!hold->booking && !picked.order.empty()) continue;
      if (!hold->release && picked.order.size() + 1 < all) continue;
      ++picked.next[robot];
      picked.order.push_back(hold);
      pick(zone, picked);
      picked.order.pop_back();
      --picked.next[robot];
    }
  }

  void tryOrder(std::size_t zone, const std::vector<const CycleHold*>& order) {
    if (left_ == 0) {
      is_cut_ = true;
      return;
    }
    --left_;
    graph_.addOrder(order);
    if (!graph_.isCircular()) walkZone(zone + 1);
    graph_.removeOrder();
  }

  const Workload& work_;
  std::size_t left_;
  std::function<void(const OrderGraph&)> visit_;
  OrderGraph graph_;
  bool is_cut_ = false;
};

}  // namespace

bool forEachOrder(const Workload& work, std::size_t max_looked_at,
                  const std::function<void(const OrderGraph&)>& visit) {
  return OrderWalk(work, max_looked_at, visit).run();
}

}  // namespace cobot_command::cell
