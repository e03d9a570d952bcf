// How things stand, for everyone.
#include <algorithm>
#include <tuple>

#include "supervision/parts.h"
#include <fmt/format.h>

namespace cobot_command::cell {

namespace {

auto significant(const RobotStatus& robot) {
  return std::tie(robot.state, robot.session, robot.acknowledged, robot.joins, robot.place, robot.reason,
                  robot.blocked_by, robot.place_in_queue, robot.text);
}
auto significant(const ZoneStatus& zone) {
  return std::tie(zone.state, zone.owner, zone.waiting);
}

template <class Status>
bool areAllAlike(const std::vector<Status>& some, const std::vector<Status>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const Status& a, const Status& b) { return significant(a) == significant(b); });
}

}  // namespace

bool areAlike(const CellStatus& one, const CellStatus& other) {
  return one.mode == other.mode && one.events == other.events && one.is_finishing == other.is_finishing &&
         one.diagnosis == other.diagnosis && areAllAlike(one.robots, other.robots) &&
         areAllAlike(one.zones, other.zones);
}

const char* toString(SupervisorMode mode) {
  constexpr const char* kNames[] = {"STARTING", "READY", "RUNNING", "HOLDING", "RECOVERY", "FAULT"};
  return kNames[static_cast<std::size_t>(mode)];
}

const char* toString(RobotState state) {
  constexpr const char* kNames[] = {"ABSENT", "READY",    "MOVING", "WAITING", "LOST",
                                    "MANUAL", "OFF_PATH", "FAULT",  "OUT"};
  return kNames[static_cast<std::size_t>(state)];
}

const char* toString(WaitReason reason) {
  constexpr const char* kNames[] = {"",        "ZONE_HELD", "WOULD_BLOCK", "AGED", "QUARANTINED",
                                    "HOLDING", "SCHEDULED"};
  return kNames[static_cast<std::size_t>(reason)];
}

const char* toString(ZoneState state) {
  constexpr const char* kNames[] = {"FREE", "HELD", "QUARANTINED"};
  return kNames[static_cast<std::size_t>(state)];
}

std::vector<std::string> Supervision::Parts::namesOf(const std::vector<RobotIndex>& robots) const {
  std::vector<std::string> names;
  for (const RobotIndex robot : robots) {
    if (std::find(names.begin(), names.end(), nameOf(robot)) == names.end()) names.push_back(nameOf(robot));
  }
  return names;
}

RobotState Supervision::Parts::stateOf(RobotIndex robot, Instant now) const {
  const RobotWatch& watch = robots_[robot];
  if (record_.robot(robot).is_out) return RobotState::Out;
  if (!watch.wasHeard()) return RobotState::Absent;
  if (isLost(robot, now)) return RobotState::Lost;
  if (watch.report().condition == RobotCondition::OffPath) return RobotState::OffPath;
  if (!watch.fault().empty() || !watch.isLinked()) return RobotState::Fault;
  if (!is_confirmed_[robot]) return RobotState::Absent;
  if (watch.report().condition == RobotCondition::Manual) return RobotState::Manual;
  if (watch.request) return RobotState::Waiting;
  return watch.report().moving ? RobotState::Moving : RobotState::Ready;
}

std::string Supervision::Parts::textOf(RobotIndex robot, Instant now) const {
  const RobotWatch& watch = robots_[robot];
  const CellPlace& place = rules_.model().places[robot][record_.tuple()[robot]];
  if (record_.robot(robot).is_out) return "it was taken out; recover it to bring it back";
  if (!watch.wasHeard()) return "it has not reported";
  if (isStrange(robot)) return "its node was restarted: recover it";
  if (!watch.fault().empty()) return watch.fault() + ": recover it";
  if (watch.isSilent(now, settings_.lease)) return "it does not report";
  if (!watch.isLinked()) return "no commands can be sent to it: " + watch.report().text;
  if (!is_confirmed_[robot] && watch.report().instance == 0) {
    return "it has not received the state of this supervisor";
  }
  if (!is_confirmed_[robot]) {
    return fmt::format("it is not at {}: bring it there, or recover it", place.name);
  }
  return watch.report().text;
}

RobotStatus Supervision::Parts::statusOf(RobotIndex robot, Instant now) const {
  RobotStatus status;
  status.name = nameOf(robot);
  status.state = stateOf(robot, now);
  status.session = record_.robot(robot).session;
  status.acknowledged = record_.robot(robot).acknowledged;
  status.joins = record_.robot(robot).joins;
  status.place = rules_.model().places[robot][record_.tuple()[robot]].name;
  if (!isStrange(robot)) status.report = robots_[robot].report().number;
  status.report_age = robots_[robot].age(now);
  status.text = textOf(robot, now);
  if (!robots_[robot].request) return status;
  const Granting granting = this->granting(now);
  const auto queue = granting.queue();
  status.place_in_queue =
      static_cast<std::uint32_t>(std::find(queue.begin(), queue.end(), robot) - queue.begin() + 1);
  status.waiting = now - robots_[robot].request->since;
  if (const auto hindrance = granting.hindranceOf(robot, now)) {
    status.reason = hindrance->reason;
    status.blocked_by = namesOf(hindrance->robots);
  }
  return status;
}

ZoneStatus Supervision::Parts::statusOfZone(ZoneIndex zone, Instant now) const {
  const CellModel& model = rules_.model();
  ZoneStatus status;
  status.name = model.program.zones[zone];
  const auto holder = record_.holderOf(zone);
  for (const auto& user : model.holders[zone]) {
    if (user) status.users.push_back(nameOf(*user));
  }
  if (holder) {
    status.owner = nameOf(*holder);
    status.state = isAble(*holder, now) ? ZoneState::Held : ZoneState::Quarantined;
  }
  if (intruders_[zone]) {
    if (!holder) status.owner = nameOf(*intruders_[zone]);
    status.state = ZoneState::Quarantined;
  }
  status.since = now - zone_since_[zone];
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    if (!robots_[robot].request) continue;
    const auto& wanted = model.events[robots_[robot].request->event.event].zones;
    if (std::find(wanted.begin(), wanted.end(), zone) != wanted.end()) {
      status.waiting.push_back(nameOf(robot));
    }
  }
  return status;
}

std::string Supervision::Parts::diagnosis() const {
  if (!start_fault_.empty()) return start_fault_;
  if (record_.isBroken()) {
    return "the journal cannot be written: nothing is granted until the supervisor is restarted";
  }
  const auto waits_for = unconfirmed();
  if (!waits_for.empty()) {
    return fmt::format(
        "{} {}", is_restarted_ ? "must be recovered, or report from their last place:" : "not ready yet:",
        fmt::join(namesOf(waits_for), ", "));
  }
  if (record_.held()) return *record_.held();
  return record_.isFinishing() ? "no robot leaves home any more" : "";
}

CellStatus Supervision::Parts::status(Instant now) const {
  CellStatus status;
  status.cell = rules_.model().program.name;
  status.hash = hash_;
  status.instance = record_.instance();
  status.epoch = record_.epoch();
  status.events = record_.events();
  status.mode = mode();
  status.policy = turns_.isUsed() ? "schedule" : toString(rules_.policy());
  status.is_finishing = record_.isFinishing();
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) status.robots.push_back(statusOf(robot, now));
  for (ZoneIndex zone = 0; zone < zone_holders_.size(); ++zone) {
    status.zones.push_back(statusOfZone(zone, now));
  }
  status.diagnosis = diagnosis();
  return status;
}

}  // namespace cobot_command::cell
