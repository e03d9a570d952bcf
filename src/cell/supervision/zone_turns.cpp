#include "supervision/zone_turns.h"

#include <algorithm>

namespace cobot_command::cell {

std::vector<ZoneIndex> zonesBookedBy(const CellEvent& event) {
  return event.kind == CellEvent::Kind::Book ? event.zones : std::vector<ZoneIndex>();
}

std::optional<RobotIndex> ZoneTurns::before(RobotIndex robot, const std::vector<ZoneIndex>& zones) const {
  if (!isUsed() || is_suspended_) return std::nullopt;
  for (const ZoneIndex zone : zones) {
    const auto& order = orders_[zone];
    const bool is_in_order = std::find(order.begin(), order.end(), robot) != order.end();
    if (is_in_order && order[next_[zone]] != robot) return order[next_[zone]];
  }
  return std::nullopt;
}

void ZoneTurns::booked(RobotIndex robot, const std::vector<ZoneIndex>& zones) {
  for (const ZoneIndex zone : zones) {
    if (!isUsed()) return;
    const auto& order = orders_[zone];
    for (std::size_t passed = 0; passed < order.size(); ++passed) {
      const std::size_t turn = (next_[zone] + passed) % order.size();
      if (order[turn] != robot) continue;
      next_[zone] = (turn + 1) % order.size();
      break;
    }
  }
}

void ZoneTurns::takenBack(RobotIndex robot, const std::vector<ZoneIndex>& zones) {
  for (const ZoneIndex zone : zones) {
    if (!isUsed() || orders_[zone].empty()) continue;
    const std::size_t last = (next_[zone] + orders_[zone].size() - 1) % orders_[zone].size();
    if (orders_[zone][last] == robot) next_[zone] = last;
  }
}

void ZoneTurns::beginAnew() {
  std::fill(next_.begin(), next_.end(), 0);
  is_suspended_ = false;
}

}  // namespace cobot_command::cell
