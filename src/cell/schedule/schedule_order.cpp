#include "cobot_command/cell/schedule/schedule_order.h"

#include <utility>

namespace cobot_command::cell {

ScheduleOrder::ScheduleOrder(const std::vector<ZoneOrder>& zones) {
  for (const ZoneOrder& order : zones) {
    Zone zone;
    for (const ScheduledHold& hold : order.holds) {
      if (hold.decision) zone.turns.push_back({hold.robot, *hold.decision});
    }
    if (!zone.turns.empty()) zones_.push_back(std::move(zone));
  }
}

bool ScheduleOrder::hasTurn(const Zone& zone, automata::EventIndex event) {
  for (const Turn& turn : zone.turns) {
    if (turn.event == event) return true;
  }
  return false;
}

std::optional<std::size_t> ScheduleOrder::awaits(automata::EventIndex event) const {
  if (!is_on_) return std::nullopt;
  for (const Zone& zone : zones_) {
    const Turn& turn = zone.turns[zone.next];
    if (turn.event != event && hasTurn(zone, event)) return turn.robot;
  }
  return std::nullopt;
}

bool ScheduleOrder::allows(automata::EventIndex event) const {
  return !awaits(event).has_value();
}

void ScheduleOrder::granted(automata::EventIndex event) {
  if (!is_on_) return;
  for (Zone& zone : zones_) {
    if (hasTurn(zone, event)) zone.next = (zone.next + 1) % zone.turns.size();
  }
}

void ScheduleOrder::withdrawn(automata::EventIndex event) {
  if (!is_on_) return;
  for (Zone& zone : zones_) {
    if (hasTurn(zone, event)) zone.next = (zone.next + zone.turns.size() - 1) % zone.turns.size();
  }
}

void ScheduleOrder::switchOff() {
  is_on_ = false;
}

void ScheduleOrder::allHome() {
  if (is_on_) return;
  is_on_ = true;
  for (Zone& zone : zones_) zone.next = 0;
}

}  // namespace cobot_command::cell
