// What people ask for.
#include <algorithm>

#include "supervision/parts.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

PersonsAnswer refused(std::string why) {
  return {false, std::move(why)};
}

PersonsAnswer noSuchRobot(const std::string& name, const std::vector<RobotProgram>& robots) {
  std::vector<std::string> names;
  names.reserve(robots.size());
  for (const RobotProgram& robot : robots) names.push_back(robot.name);
  return refused(fmt::format("there is no robot \"{}\": the cell has {}", foreignText(name, kQuoteLimit),
                             fmt::join(names, ", ")));
}

std::string placeNames(const std::vector<CellPlace>& places) {
  std::vector<std::string> names;
  names.reserve(places.size());
  for (const CellPlace& place : places) names.push_back(place.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Whom a report has to be meant for.
struct Listener {
  const std::string& hash;
  std::uint64_t instance = 0;
  Duration lease{};
};

/// Why nothing can be said of where that robot stands, or nothing sent to it.
std::optional<std::string> objectionTo(const RobotWatch& watch, const std::string& name, const Listener& to,
                                       Instant now) {
  if (!watch.wasHeard() || watch.isSilent(now, to.lease)) {
    return name + " does not report: start its node";
  }
  if (watch.report().hash != to.hash) return name + " uses another artifact: load the same on both";
  if (watch.report().moving) return name + " moves: wait until it is at standstill";
  if (watch.report().condition == RobotCondition::Manual ||
      watch.report().condition == RobotCondition::Error) {
    return fmt::format("{} is {}: end that at its pendant first", name, toString(watch.report().condition));
  }
  if (!watch.isLinked()) {
    return fmt::format("no commands can be sent to {}: {}", name, watch.report().text);
  }
  if (watch.report().instance != 0 && watch.report().instance != to.instance) {
    return name + " follows a supervisor that lost its journal: restart its node";
  }
  if (!watch.isFresh(to.lease)) {
    return fmt::format("the joints of {} were measured {:.1f} s ago: check its status stream first", name,
                       watch.report().status_age);
  }
  return std::nullopt;
}

constexpr const char* kNotWritten = "the journal cannot be written; nothing was changed";

}  // namespace

PersonsAnswer Supervision::Parts::hold(bool on, Instant now) {
  if (!record_.hold(on, "hold was requested")) return refused(kNotWritten);
  settle(now);
  if (!on && record_.held()) return refused("still nothing is granted: " + *record_.held());
  return {true,
          on ? "nothing new is granted; motions that were sent are completed" : "bookings are granted again"};
}

PersonsAnswer Supervision::Parts::finish(bool on, Instant now) {
  if (!record_.finish(on)) return refused(kNotWritten);
  settle(now);
  return {true, on ? "no robot leaves home any more" : "robots leave home again"};
}

PersonsAnswer Supervision::Parts::stop(Instant now) {
  const std::string why = "stop was requested";
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) ports_.stop({robot, why});
  const bool is_written = record_.hold(true, why);
  settle(now);
  return {true, is_written ? "all robots are being stopped; they keep their zones"
                           : "all robots are being stopped, but the journal cannot be written"};
}

PersonsAnswer Supervision::Parts::recover(const std::string& name, const std::string& place_name,
                                          const std::string& person, Instant now) {
  const auto robot = record_.robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  const auto& places = rules_.model().places[*robot];
  const auto place = std::find_if(places.begin(), places.end(),
                                  [&](const CellPlace& one) { return one.name == place_name; });
  if (place == places.end()) {
    return refused(fmt::format("{} has no place \"{}\" in its program; it has {}", name,
                               foreignText(place_name, kQuoteLimit), placeNames(places)));
  }
  const auto state = static_cast<automata::StateIndex>(place - places.begin());
  if (const auto objection = objectionToRecovery(*robot, state, person, now)) return refused(*objection);
  const std::uint64_t session = robots_[*robot].session();
  const std::uint64_t number = robots_[*robot].highestNumber();
  if (!record_.recover(*robot, state, person) || !record_.join(*robot, session, number)) {
    return refused(kNotWritten);
  }
  robots_[*robot].joined();
  is_confirmed_[*robot] = true;
  settle(now);
  if (place->station) return {true, fmt::format("{} is at {}, and continues from there", name, place_name)};
  return {true,
          fmt::format("{} is at {}: it continues from there if its step is a motion of joints (PTP with JPP, "
                      "or a mechanism's); else bring it to a station by hand, and recover it there",
                      name, place_name)};
}

std::optional<std::string> Supervision::Parts::objectionToRecovery(RobotIndex robot,
                                                                   automata::StateIndex place,
                                                                   const std::string& person,
                                                                   Instant now) const {
  const RobotWatch& watch = robots_[robot];
  const CellPlace& where = rules_.model().places[robot][place];
  if (!start_fault_.empty()) return start_fault_;
  if (person.empty()) return "person is empty: name who recovers it";
  if (auto unfit = objectionTo(watch, nameOf(robot), {hash_, record_.instance(), settings_.lease}, now)) {
    return unfit;
  }
  if (!ports_.fits(robot, place, watch.report().joints)) {
    std::vector<CellPlace> fitting;
    for (automata::StateIndex other = 0; other < rules_.model().places[robot].size(); ++other) {
      const bool fits = ports_.fits(robot, other, watch.report().joints);
      if (fits) fitting.push_back(rules_.model().places[robot][other]);
    }
    return fmt::format("{} is not at {}: {}", nameOf(robot), where.name,
                       fitting.empty() ? "bring it to a place of its program by hand"
                                       : "by its joints it can be at " + placeNames(fitting));
  }
  for (const std::uint32_t zone : watch.report().touched_zones) {
    if (zone < rules_.model().program.zones.size() &&
        !std::binary_search(where.holds.begin(), where.holds.end(), zone)) {
      return fmt::format("{} is in {}, which it does not hold at {}", nameOf(robot),
                         rules_.model().program.zones[zone], where.name);
    }
  }
  const auto tuple = record_.placed(robot, place);
  if (!tuple) return fmt::format("another robot holds a zone that {} has at {}", nameOf(robot), where.name);
  if (const auto intrusion = rules_.intrusionIn(*tuple)) {
    return fmt::format("{} was released, and enters {} automatically: wait until it has left the zone",
                       nameOf(intrusion->mechanism), rules_.model().program.zones[intrusion->zone]);
  }
  const auto stuck = rules_.stuckIn(*tuple);
  if (!stuck.empty()) {
    return fmt::format("from there {} could not return home: bring it to another place",
                       fmt::join(namesOf(stuck), ", "));
  }
  return std::nullopt;
}

PersonsAnswer Supervision::Parts::confirmClear(const std::string& name, const std::string& person,
                                               bool was_moved, Instant now) {
  const auto robot = record_.robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  const RobotWatch& watch = robots_[*robot];
  if (isAble(*robot, now)) {
    return refused(fmt::format("{} is not lost: stop it first, or take it out at home", name));
  }
  if (person.empty()) return refused("person is empty: name who confirms");
  if (watch.wasHeard() && !watch.isSilent(now, settings_.lease) && watch.report().moving) {
    return refused(fmt::format("{} moves: wait until it is at standstill", name));
  }
  if (watch.wasHeard() && !watch.isSilent(now, settings_.lease) && !watch.report().touched_zones.empty()) {
    return refused(fmt::format("{} is measured in {} now: move it out, or end its node first", name,
                               rules_.model().program.zones.at(watch.report().touched_zones.front())));
  }
  if (!was_moved && watch.wasHeard() && !watch.report().touched_zones.empty()) {
    return refused(fmt::format("{} was in {} in its last report: move it out, then set was_moved", name,
                               rules_.model().program.zones.at(watch.report().touched_zones.front())));
  }
  if (!was_moved && watch.wasHeard() && watch.report().moving) {
    return refused(fmt::format(
        "{} moved in its last report, and can have moved further: check where it is, then set was_moved",
        name));
  }
  if (!record_.takeOut(*robot, person)) return refused(kNotWritten);
  robots_[*robot].forgetPlace();
  settle(now);
  return {true, fmt::format("the zones of {} are free; it is out of the cell until it is recovered", name)};
}

PersonsAnswer Supervision::Parts::takeOut(const std::string& name, const std::string& person, Instant now) {
  const auto robot = record_.robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  if (person.empty()) return refused("person is empty: name who takes it out");
  const bool is_home = record_.tuple()[*robot] == rules_.initial()[*robot] && !robots_[*robot].request;
  if (!is_home) {
    return refused(
        fmt::format("{} is not at home: let it finish, or confirm that its zones are clear", name));
  }
  if (!rules_.model().places[*robot][record_.tuple()[*robot]].holds.empty()) {
    return refused(fmt::format(
        "{} holds a zone at home, which would become free although the robot is in it: leave it in the cell",
        name));
  }
  if (!record_.takeOut(*robot, person)) return refused(kNotWritten);
  settle(now);
  return {true, fmt::format("{} is out of the cell until it is recovered", name)};
}

}  // namespace cobot_command::cell
