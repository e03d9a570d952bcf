#include "supervision/granting.h"

#include <algorithm>
#include <utility>

namespace cobot_command::cell {

using Verdict = automata::Decision::Verdict;

std::vector<RobotIndex> Granting::queue() const {
  std::vector<RobotIndex> queue;
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    if (robots_[robot].request) queue.push_back(robot);
  }
  std::stable_sort(queue.begin(), queue.end(), [this](RobotIndex one, RobotIndex other) {
    return robots_[one].request->since < robots_[other].request->since;
  });
  return queue;
}

std::optional<RobotIndex> Granting::next(Instant now) const {
  for (const RobotIndex robot : queue()) {
    if (!hindranceOf(robot, now)) return robot;
  }
  return std::nullopt;
}

Situation Granting::situation(Instant now) const {
  Situation situation{record_.tuple(), {}, {}, conditions_.grants, conditions_.is_finishing};
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    const auto& request = robots_[robot].request;
    Situation::Robot known;
    known.is_able = conditions_.is_able(robot);
    if (request) {
      known.number = request->event.number;
      known.since = request->since;
      known.is_aged = now - request->since >= conditions_.aging;
    }
    situation.robots.push_back(known);
  }
  for (ZoneIndex zone = 0; zone < rules_.model().program.zones.size(); ++zone) {
    situation.intruders.push_back(conditions_.intruder(zone));
  }
  return situation;
}

std::optional<Hindrance> Granting::hindranceOf(RobotIndex robot, Instant now) const {
  conditions_.memo->follow(situation(now));
  // Whose turn it is by the schedule changes with time alone.
  if (conditions_.turns->isUsed()) return findHindrance(robot, now);
  const auto known = conditions_.memo->found.find(robot);
  if (known != conditions_.memo->found.end()) return known->second;
  return conditions_.memo->found.emplace(robot, findHindrance(robot, now)).first->second;
}

std::optional<Hindrance> Granting::findHindrance(RobotIndex robot, Instant now) const {
  if (!conditions_.grants || !conditions_.is_able(robot)) return Hindrance{WaitReason::Holding, {}};
  auto own = ownHindrance(robot);
  if (own) return own;
  if (const auto turn = whoseTurn(robot, now)) return Hindrance{WaitReason::Scheduled, {*turn}};
  const auto aged = agedBefore(robot, now);
  if (aged) return Hindrance{WaitReason::Aged, {*aged}};
  return std::nullopt;
}

std::optional<RobotIndex> Granting::whoseTurn(RobotIndex robot, Instant now) const {
  const Request& request = *robots_[robot].request;
  const auto first =
      conditions_.turns->before(robot, zonesBookedBy(rules_.model().events[request.event.event]));
  if (!first) return std::nullopt;
  // One that has done its cycles is passed over.
  const bool is_idle = record_.tuple()[*first] == rules_.initial()[*first] && !robots_[*first].request;
  return is_idle && now - request.since >= kTurnPatience ? std::nullopt : first;
}

bool Granting::isKeptBackForLong(RobotIndex robot, Instant now) const {
  const auto& request = robots_[robot].request;
  return request && now - request->since >= conditions_.aging && whoseTurn(robot, now).has_value();
}

std::optional<Hindrance> Granting::ownHindrance(RobotIndex robot) const {
  const automata::EventIndex wanted = robots_[robot].request->event.event;
  const CellEvent& event = rules_.model().events[wanted];
  const bool sets_out = event.kind == CellEvent::Kind::Go &&
                        record_.tuple()[robot] == rules_.initial()[robot] && conditions_.is_finishing;
  if (sets_out) return Hindrance{WaitReason::Holding, {}};
  if (auto hindrance = hindranceByZones(event)) return hindrance;
  const automata::Decision decision = rules_.decide(record_.tuple(), wanted);
  if (decision.verdict == Verdict::Granted) return std::nullopt;
  if (decision.verdict == Verdict::WouldBlock) {
    const auto intrusion = rules_.intrusionIn(decision.next);
    if (intrusion) return Hindrance{WaitReason::WouldBlock, {intrusion->mechanism, intrusion->holder}};
    return Hindrance{WaitReason::WouldBlock, rules_.stuckIn(decision.next)};
  }
  return Hindrance{WaitReason::Holding, {}};
}

std::optional<Hindrance> Granting::hindranceByZones(const CellEvent& event) const {
  Hindrance held{WaitReason::ZoneHeld, {}};
  Hindrance quarantined{WaitReason::Quarantined, {}};
  if (event.kind != CellEvent::Kind::Book) return std::nullopt;
  for (const ZoneIndex zone : event.zones) {
    const auto intruder = conditions_.intruder(zone);
    if (intruder && *intruder != event.robot) quarantined.robots.push_back(*intruder);
    const auto holder = record_.holderOf(zone);
    if (!holder || rules_.policy() == Policy::None) continue;
    (conditions_.is_able(*holder) ? held : quarantined).robots.push_back(*holder);
  }
  if (!quarantined.robots.empty()) return quarantined;
  if (!held.robots.empty()) return held;
  return std::nullopt;
}

/// For the sake of one that nothing can be done for, nobody waits.
bool Granting::canBeHelped(RobotIndex robot, const std::vector<RobotIndex>& ahead) const {
  const auto own = ownHindrance(robot);
  return own && (own->reason == WaitReason::ZoneHeld || own->reason == WaitReason::WouldBlock) &&
         !ahead.empty() && std::all_of(ahead.begin(), ahead.end(), conditions_.is_able);
}

std::vector<Helped> Granting::findHelped(Instant now) const {
  std::vector<Helped> helped;
  for (const RobotIndex robot : queue()) {
    if (now - robots_[robot].request->since < conditions_.aging) break;
    if (!conditions_.is_able(robot)) continue;
    auto ahead = rules_.aheadOf(record_.tuple(), robot);
    if (canBeHelped(robot, ahead)) helped.push_back({robot, std::move(ahead)});
  }
  return helped;
}

std::optional<RobotIndex> Granting::agedBefore(RobotIndex robot, Instant now) const {
  auto& helped = conditions_.memo->helped;
  if (!helped) helped = findHelped(now);
  for (const Helped& other : *helped) {
    const bool is_behind = std::pair(robots_[other.robot].request->since, other.robot) >=
                           std::pair(robots_[robot].request->since, robot);
    if (is_behind) break;
    if (!rules_.haveToDoWithEachOther(robot, other.robot)) continue;
    // The one that waits for longest comes first: who helps it waits for nobody else's sake. Else the helpers
    // of two that have waited for long could wait for each other.
    const bool helps = std::find(other.ahead.begin(), other.ahead.end(), robot) != other.ahead.end();
    return helps ? std::nullopt : std::optional(other.robot);
  }
  return std::nullopt;
}

}  // namespace cobot_command::cell
