#include "supervision/cell_record.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::cell {
namespace {

/// More than a robot can have told before it hears of the first one.
constexpr std::size_t kRecentEvents = 256;

}  // namespace

CellRecord::CellRecord(const Rules& rules, journal::Append append, journal::Replace replace, std::size_t most)
    : rules_(rules),
      append_(std::move(append)),
      replace_(std::move(replace)),
      most_(most),
      tuple_(rules.initial()),
      robots_(rules.model().robots()) {}

bool CellRecord::replay(const std::vector<journal::Record>& records) {
  records_ = records.size();
  return std::all_of(records.begin(), records.end(), [this](const auto& record) { return apply(record); });
}

bool CellRecord::write(const journal::Record& record) {
  if (is_broken_) return false;
  if (!append_(journal::toLine(record))) {
    is_broken_ = true;
    return false;
  }
  if (!apply(record)) return false;
  ++records_;
  makeAnew();
  return true;
}

void CellRecord::makeAnew() {
  if (records_ < most_ || !replace_) return;
  records_ = replace_(journal::toLine(snapshot())) ? 1 : 0;
}

journal::Snapshot CellRecord::snapshot() const {
  journal::Snapshot all;
  all.instance = instance_;
  all.epoch = epoch_;
  all.hash = hash_;
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    const Robot& one = robots_[robot];
    all.robots.push_back({rules_.model().program.robots[robot].name,
                          one.session,
                          one.acknowledged,
                          {one.recent.begin(), one.recent.end()},
                          one.is_out,
                          one.joins});
  }
  all.states.assign(tuple_.begin(), tuple_.end());
  all.held = held_;
  all.is_finishing = is_finishing_;
  all.events = events_;
  return all;
}

bool CellRecord::start(const std::string& hash, std::uint64_t instance) {
  return write(journal::Started{epoch_ == 0 ? instance : instance_, epoch_ + 1, hash});
}

bool CellRecord::join(RobotIndex robot, std::uint64_t session, std::uint64_t acknowledged) {
  return write(journal::Joined{rules_.model().program.robots[robot].name, session, acknowledged});
}

bool CellRecord::carryOut(RobotIndex robot, const NumberedEvent& event) {
  return write(journal::CarriedOut{rules_.model().program.robots[robot].name, robots_[robot].session, event});
}

bool CellRecord::recover(RobotIndex robot, automata::StateIndex place, const std::string& person) {
  const CellModel& model = rules_.model();
  return write(journal::Recovered{model.program.robots[robot].name, model.places[robot][place].name, person});
}

bool CellRecord::takeOut(RobotIndex robot, const std::string& person) {
  return write(journal::TakenOut{rules_.model().program.robots[robot].name, person});
}

std::optional<RobotIndex> CellRecord::robotNamed(const std::string& name) const {
  const auto& robots = rules_.model().program.robots;
  for (RobotIndex robot = 0; robot < robots.size(); ++robot) {
    if (robots[robot].name == name) return robot;
  }
  return std::nullopt;
}

bool CellRecord::hold(bool on, const std::string& reason) {
  const bool is_so = on ? held_ == reason : !held_;
  return is_so || write(journal::Held{on, reason});
}

bool CellRecord::finish(bool on) {
  return is_finishing_ == on || write(journal::Finishing{on});
}

std::optional<automata::StateIndex> CellRecord::placeNamed(RobotIndex robot, const std::string& name) const {
  const auto& places = rules_.model().places[robot];
  for (automata::StateIndex place = 0; place < places.size(); ++place) {
    if (places[place].name == name) return place;
  }
  return std::nullopt;
}

std::optional<RobotIndex> CellRecord::holderOf(ZoneIndex zone) const {
  return rules_.model().holder(zone, tuple_[rules_.model().automatonOf(zone)]);
}

std::optional<automata::Tuple> CellRecord::placed(RobotIndex robot, automata::StateIndex place) const {
  const CellModel& model = rules_.model();
  automata::Tuple tuple = tuple_;
  tuple[robot] = place;
  const auto& holds = model.places[robot][place].holds;
  for (ZoneIndex zone = 0; zone < model.holders.size(); ++zone) {
    const auto holder = holderOf(zone);
    const bool is_wanted = std::binary_search(holds.begin(), holds.end(), zone);
    if (is_wanted && holder && *holder != robot) return std::nullopt;
    if (!is_wanted && holder != robot) continue;
    const std::optional<RobotIndex> owner = is_wanted ? std::optional(robot) : std::nullopt;
    const auto& states = model.holders[zone];
    const auto state = std::find(states.begin(), states.end(), owner);
    tuple[model.automatonOf(zone)] = static_cast<automata::StateIndex>(state - states.begin());
  }
  return tuple;
}

bool CellRecord::apply(const journal::Record& record) {
  return std::visit(
      Overloaded{[this](const journal::Started& one) {
                   instance_ = one.instance;
                   epoch_ = one.epoch;
                   hash_ = one.hash;
                   return true;
                 },
                 [this](const journal::Joined& one) {
                   const auto robot = robotNamed(one.robot);
                   if (!robot) return false;
                   robots_[*robot] = {one.session, one.acknowledged, {}, false, robots_[*robot].joins + 1};
                   return true;
                 },
                 [this](const journal::CarriedOut& one) { return apply(one); },
                 [this](const journal::Recovered& one) {
                   const auto robot = robotNamed(one.robot);
                   const auto place = robot ? placeNamed(*robot, one.place) : std::nullopt;
                   const auto tuple = place ? placed(*robot, *place) : std::nullopt;
                   if (tuple) tuple_ = *tuple;
                   return tuple.has_value();
                 },
                 [this](const journal::TakenOut& one) { return apply(one); },
                 [this](const journal::Held& one) {
                   held_ = one.on ? std::optional(one.reason) : std::nullopt;
                   return true;
                 },
                 [this](const journal::Finishing& one) {
                   is_finishing_ = one.on;
                   return true;
                 },
                 [this](const journal::Snapshot& one) { return apply(one); }},
      record);
}

bool CellRecord::apply(const journal::CarriedOut& record) {
  const auto index = robotNamed(record.robot);
  if (!index) return false;
  Robot& robot = robots_[*index];
  const NumberedEvent& event = record.event;
  const bool was_granted = event.number == robot.acknowledged + 1;
  if (event.kind == NumberedEvent::Kind::Withdrawn) {
    if (was_granted) {
      const auto before = rules_.undone(tuple_, event.event);
      if (!before) return false;
      tuple_ = *before;
    } else if (event.number != robot.acknowledged + 2) {
      return false;
    }
  } else {
    automata::Decision decision = rules_.decide(tuple_, event.event);
    if (!was_granted || decision.verdict != automata::Decision::Verdict::Granted) return false;
    tuple_ = std::move(decision.next);
  }
  robot.acknowledged = event.number;
  robot.recent.push_back(event);
  if (robot.recent.size() > kRecentEvents) robot.recent.pop_front();
  ++events_;
  return true;
}

bool CellRecord::apply(const journal::TakenOut& record) {
  const auto robot = robotNamed(record.robot);
  if (!robot) return false;
  // Its zones go to nobody while it is away; a zone that it holds at home is its own again when it comes
  // back.
  tuple_[*robot] = rules_.initial()[*robot];
  for (ZoneIndex zone = 0; zone < rules_.model().holders.size(); ++zone) {
    if (holderOf(zone) == robot) tuple_[rules_.model().automatonOf(zone)] = 0;
  }
  robots_[*robot].session = 0;
  robots_[*robot].is_out = true;
  return true;
}

bool CellRecord::apply(const journal::Snapshot& snapshot) {
  if (snapshot.robots.size() != robots_.size() || snapshot.states.size() != tuple_.size()) return false;
  for (std::size_t index = 0; index < tuple_.size(); ++index) {
    if (snapshot.states[index] >= rules_.model().problem.automata[index].states.size()) return false;
  }
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    const journal::Snapshot::Robot& one = snapshot.robots[robot];
    if (one.robot != rules_.model().program.robots[robot].name) return false;
    robots_[robot] = {
        one.session, one.acknowledged, {one.recent.begin(), one.recent.end()}, one.is_out, one.joins};
  }
  instance_ = snapshot.instance;
  epoch_ = snapshot.epoch;
  hash_ = snapshot.hash;
  tuple_.assign(snapshot.states.begin(), snapshot.states.end());
  held_ = snapshot.held;
  is_finishing_ = snapshot.is_finishing;
  events_ = snapshot.events;
  return true;
}

}  // namespace cobot_command::cell
