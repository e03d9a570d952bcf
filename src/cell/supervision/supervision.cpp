#include "cobot_command/cell/supervision/supervision.h"

#include <algorithm>

#include "supervision/parts.h"
#include <fmt/format.h>

namespace cobot_command::cell {
Supervision::Supervision(Rules rules, std::string hash, std::uint64_t instance,
                         const std::vector<journal::Record>& records, SupervisionSettings settings,
                         SupervisionPorts ports)
    : parts_(std::make_unique<Parts>(std::move(rules), std::move(hash), instance, records,
                                     std::move(settings), std::move(ports))) {}
Supervision::~Supervision() = default;

bool Supervision::take(const RobotReport& report, Instant now) {
  return parts_->take(report, now);
}
void Supervision::tick(Instant now) {
  parts_->settle(now);
}
PersonsAnswer Supervision::hold(bool on, Instant now) {
  return parts_->hold(on, now);
}
PersonsAnswer Supervision::finish(bool on, Instant now) {
  return parts_->finish(on, now);
}
PersonsAnswer Supervision::stop(Instant now) {
  return parts_->stop(now);
}
PersonsAnswer Supervision::recover(const std::string& robot, const std::string& place,
                                   const std::string& person, Instant now) {
  return parts_->recover(robot, place, person, now);
}
PersonsAnswer Supervision::confirmClear(const std::string& robot, const std::string& person, bool was_moved,
                                        Instant now) {
  return parts_->confirmClear(robot, person, was_moved, now);
}
PersonsAnswer Supervision::takeOut(const std::string& robot, const std::string& person, Instant now) {
  return parts_->takeOut(robot, person, now);
}
CellStatus Supervision::status(Instant now) const {
  return parts_->status(now);
}
const automata::Tuple& Supervision::tuple() const {
  return parts_->tuple();
}
const SupervisionCounts& Supervision::counts() const {
  return parts_->counts();
}
std::optional<Instant> Supervision::nextDeadline() const {
  return parts_->nextDeadline();
}

// --- Parts.

Supervision::Parts::Parts(Rules rules, std::string hash, std::uint64_t instance,
                          const std::vector<journal::Record>& records, SupervisionSettings settings,
                          SupervisionPorts ports)
    : rules_(std::move(rules)),
      hash_(std::move(hash)),
      settings_(std::move(settings)),
      ports_(std::move(ports)),
      record_(rules_, ports_.append, ports_.replace, settings_.most_records),
      turns_(settings_.turns),
      robots_(rules_.model().robots()),
      zone_holders_(rules_.model().program.zones.size()),
      intruders_(zone_holders_.size()),
      zone_since_(zone_holders_.size()),
      is_confirmed_(robots_.size(), false) {
  for (const journal::Record& record : records) {
    const std::string* const hash_of_record = journal::hashOf(record);
    if (hash_of_record != nullptr && *hash_of_record != hash_) {
      start_fault_ = fmt::format(
          "the journal belongs to another artifact ({}, the supervisor has {}): bring all robots home, and "
          "start a new journal",
          hash_of_record->substr(0, 8), hash_.substr(0, 8));
      return;
    }
    is_restarted_ = is_restarted_ || journal::tellsOfRobots(record);
  }
  if (!record_.replay(records)) {
    start_fault_ = "the journal contains impossible events: bring all robots home, and start a new journal";
    return;
  }
  if (!record_.start(hash_, instance)) start_fault_ = "the journal cannot be written";
}

SupervisorMode Supervision::Parts::mode() const {
  if (!start_fault_.empty() || record_.isBroken()) return SupervisorMode::Fault;
  if (!unconfirmed().empty()) return is_restarted_ ? SupervisorMode::Recovery : SupervisorMode::Starting;
  if (record_.held()) return SupervisorMode::Holding;
  const bool is_idle =
      std::none_of(robots_.begin(), robots_.end(), [](const auto& robot) { return robot.request; });
  return is_idle && rules_.isHome(record_.tuple()) ? SupervisorMode::Ready : SupervisorMode::Running;
}

std::vector<RobotIndex> Supervision::Parts::unconfirmed() const {
  std::vector<RobotIndex> robots;
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    if (!is_confirmed_[robot] && !record_.robot(robot).is_out) robots.push_back(robot);
  }
  return robots;
}

bool Supervision::Parts::isStrange(RobotIndex robot) const {
  const std::uint64_t listened = record_.robot(robot).session;
  return listened != 0 && robots_[robot].wasHeard() && robots_[robot].session() != listened;
}

bool Supervision::Parts::isLost(RobotIndex robot, Instant now) const {
  return isStrange(robot) || robots_[robot].isSilent(now, settings_.lease);
}

bool Supervision::Parts::isAble(RobotIndex robot, Instant now) const {
  const RobotWatch& watch = robots_[robot];
  const RobotCondition condition = watch.report().condition;
  return watch.wasHeard() && is_confirmed_[robot] && !record_.robot(robot).is_out && watch.fault().empty() &&
         !isLost(robot, now) && (condition == RobotCondition::Ok || condition == RobotCondition::Paused);
}

Granting Supervision::Parts::granting(Instant now) const {
  const SupervisorMode mode = this->mode();
  GrantingConditions conditions;
  conditions.grants = mode == SupervisorMode::Ready || mode == SupervisorMode::Running;
  conditions.is_finishing = record_.isFinishing();
  conditions.aging = settings_.aging;
  conditions.is_able = [this, now](RobotIndex robot) { return isAble(robot, now); };
  conditions.intruder = [this](ZoneIndex zone) { return intruders_[zone]; };
  conditions.turns = &turns_;
  conditions.memo = &memo_;
  return {rules_, record_, robots_, std::move(conditions)};
}

void Supervision::Parts::settle(Instant now) {
  if (settled_at_ == Instant{}) std::fill(zone_since_.begin(), zone_since_.end(), now);
  settled_at_ = now;
  if (start_fault_.empty()) findIntruders();
  if (mode() != SupervisorMode::Fault) {
    grant(now);
  }
  for (ZoneIndex zone = 0; zone < zone_holders_.size(); ++zone) {
    const auto holder = record_.holderOf(zone);
    if (holder == zone_holders_[zone]) continue;
    zone_holders_[zone] = holder;
    zone_since_[zone] = now;
  }
}

void Supervision::Parts::grant(Instant now) {
  const Granting granting = this->granting(now);
  // Behind a fault, and where somebody is kept back for too long, the supervisor alone rules until all are
  // home.
  if (rules_.isHome(record_.tuple())) turns_.beginAnew();
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    const bool fails = !record_.robot(robot).is_out && !isAble(robot, now);
    if (fails || granting.isKeptBackForLong(robot, now)) turns_.suspend();
  }
  while (const auto robot = granting.next(now)) {
    const NumberedEvent event = robots_[*robot].request->event;
    if (!record_.carryOut(*robot, event)) return;
    turns_.booked(*robot, zonesBookedBy(rules_.model().events[event.event]));
    robots_[*robot].request.reset();
  }
}

/// Bodies in a zone that is not theirs: it is kept from the others; two robots in one zone are stopped.
void Supervision::Parts::findIntruders() {
  std::set<std::array<std::size_t, 3>> lasting;
  for (ZoneIndex zone = 0; zone < intruders_.size(); ++zone) {
    const auto holder = record_.holderOf(zone);
    intruders_[zone].reset();
    if (rules_.policy() == Policy::None) continue;
    for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
      if (holder == robot || !robots_[robot].wasHeard() || !robots_[robot].touches(zone)) continue;
      const bool is_alone = !holder && !intruders_[zone];
      const RobotIndex other = holder ? *holder : intruders_[zone].value_or(robot);
      intruders_[zone] = robot;
      if (is_alone) continue;
      lasting.insert({zone, robot, other});
      if (intrusions_.count({zone, robot, other}) != 0 && record_.held()) continue;
      const std::string why = fmt::format(
          "INTRUSION: {} is in {}, which {} {}: bring it out, and continue by hold with false", nameOf(robot),
          rules_.model().program.zones[zone], nameOf(other), holder ? "holds" : "is also in");
      ports_.stop({robot, why});
      ports_.stop({other, why});
      (void)record_.hold(true, why);
    }
  }
  intrusions_ = std::move(lasting);
}

std::optional<Instant> Supervision::Parts::nextDeadline() const {
  std::optional<Instant> first;
  const auto take = [&](Instant when) {
    const bool is_over = when <= settled_at_;
    if (!is_over && (!first || when < *first)) first = when;
  };
  for (const RobotWatch& robot : robots_) {
    if (robot.heard()) take(*robot.heard() + settings_.lease + Duration(1));
    if (robot.request) take(robot.request->since + settings_.aging);
    if (robot.request && turns_.isUsed()) take(robot.request->since + kTurnPatience);
  }
  return first;
}

}  // namespace cobot_command::cell
