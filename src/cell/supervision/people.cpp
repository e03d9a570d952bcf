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
  for (const RobotProgram& robot : robots) names.push_back(robot.name);
  return refused(fmt::format("there is no robot \"{}\": the cell has {}", foreignText(name, kQuoteLimit),
                             fmt::join(names, ", ")));
}

constexpr const char* kNotWritten = "the journal cannot be written, so that nothing was done";

}  // namespace

PersonsAnswer Supervision::Parts::hold(bool on, Instant now) {
  holds_ = on;
  hold_reason_ = on ? "hold was asked for" : "";
  settle(now);
  return {true, on ? "nothing new is granted; what was sent goes to its end" : "bookings are granted again"};
}

PersonsAnswer Supervision::Parts::finish(bool on, Instant now) {
  is_finishing_ = on;
  settle(now);
  return {true, on ? "no robot sets out from home any more" : "robots set out from home again"};
}

PersonsAnswer Supervision::Parts::stop(Instant now) {
  holds_ = true;
  hold_reason_ = "stop was asked for";
  for (RobotIndex robot = 0; robot < robots_.size(); ++robot) {
    if (!record_.robot(robot).is_out) stop_orders_.push_back({robot, hold_reason_});
  }
  settle(now);
  return {true, "all robots are told to stop; their zones stay"};
}

PersonsAnswer Supervision::Parts::recover(const std::string& name, const std::string& place_name,
                                          const std::string& person, Instant now) {
  const auto robot = robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  const auto& places = rules_.model().places[*robot];
  const auto place = std::find_if(places.begin(), places.end(),
                                  [&](const CellPlace& one) { return one.name == place_name; });
  if (place == places.end()) {
    return refused(
        fmt::format("{} has no place \"{}\" in its program", name, foreignText(place_name, kQuoteLimit)));
  }
  const auto state = static_cast<automata::StateIndex>(place - places.begin());
  if (const auto objection = objectionToRecovery(*robot, state, now)) return refused(*objection);
  const std::uint64_t session = robots_[*robot].session();
  const std::uint64_t number = robots_[*robot].highestNumber();
  if (!record_.recover(*robot, state, person) || !record_.join(*robot, session, number)) {
    return refused(kNotWritten);
  }
  robots_[*robot].joined();
  is_confirmed_[*robot] = true;
  settle(now);
  return {true, fmt::format("{} is at {}, and goes on from there", name, place_name)};
}

std::optional<std::string> Supervision::Parts::objectionToRecovery(RobotIndex robot,
                                                                   automata::StateIndex place,
                                                                   Instant now) const {
  const RobotWatch& watch = robots_[robot];
  const CellPlace& where = rules_.model().places[robot][place];
  if (!start_fault_.empty()) return start_fault_;
  if (!watch.wasHeard() || watch.isSilent(now, settings_.lease)) {
    return nameOf(robot) + " does not report: start its node";
  }
  if (watch.report().hash != hash_) return nameOf(robot) + " has another artifact: load the same on both";
  if (watch.report().moving) return nameOf(robot) + " moves: wait until it stands";
  if (watch.report().condition == RobotCondition::Manual ||
      watch.report().condition == RobotCondition::Error) {
    return fmt::format("{} is {}: end that at its pendant first", nameOf(robot),
                       toString(watch.report().condition));
  }
  if (!ports_.fits(robot, place, watch.report().joints)) {
    return fmt::format("{} does not stand at {}: bring it there by hand, or name where it is", nameOf(robot),
                       where.name);
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
  const auto stuck = rules_.stuckIn(*tuple);
  if (!stuck.empty()) {
    return fmt::format("from there {} could not come home any more: bring it to another place",
                       fmt::join(namesOf(stuck), ", "));
  }
  return std::nullopt;
}

PersonsAnswer Supervision::Parts::confirmClear(const std::string& name, const std::string& person,
                                               bool was_moved, Instant now) {
  const auto robot = robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  const RobotWatch& watch = robots_[*robot];
  if (isAble(*robot, now)) {
    return refused(fmt::format("{} is not lost: stop it first, or take it out at home", name));
  }
  if (person.empty()) return refused("it has to be said who confirms");
  if (!was_moved && watch.wasHeard() && !watch.report().touched_zones.empty()) {
    return refused(
        fmt::format("{} was measured in {} when it was heard last: say that it was moved, once it was", name,
                    rules_.model().program.zones.at(watch.report().touched_zones.front())));
  }
  if (!record_.takeOut(*robot, person)) return refused(kNotWritten);
  robots_[*robot].forgetPlace();
  settle(now);
  return {true, fmt::format("the zones of {} are free; it is out of the cell until it is recovered", name)};
}

PersonsAnswer Supervision::Parts::takeOut(const std::string& name, const std::string& person, Instant now) {
  const auto robot = robotNamed(name);
  if (!robot) return noSuchRobot(name, rules_.model().program.robots);
  if (person.empty()) return refused("it has to be said who takes it out");
  const bool is_home = record_.tuple()[*robot] == rules_.initial()[*robot] && !robots_[*robot].request;
  if (!is_home) {
    return refused(
        fmt::format("{} is not at home: let it finish, or confirm that its zones are clear", name));
  }
  if (!record_.takeOut(*robot, person)) return refused(kNotWritten);
  settle(now);
  return {true, fmt::format("{} is out of the cell until it is recovered", name)};
}

}  // namespace cobot_command::cell
