// What robots tell, taken one after the other.
#include <algorithm>

#include "supervision/parts.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

using Kind = NumberedEvent::Kind;

/// What a robot's condition means for its program; nothing: it goes on, or will.
const char* endedBy(RobotCondition condition) {
  switch (condition) {
    case RobotCondition::Stopped:
      return "its program has been stopped";
    case RobotCondition::Error:
      return "it has an error";
    case RobotCondition::OffPath:
      return "it is off the path of its program";
    case RobotCondition::Ok:
    case RobotCondition::Paused:
    case RobotCondition::Manual:
    case RobotCondition::Unlinked:
      break;
  }
  return nullptr;
}

/// Why it is no event of that robot; nothing: it is.
std::optional<std::string> objectionTo(const CellModel& model, RobotIndex robot, const NumberedEvent& event) {
  if (event.event >= model.events.size()) {
    return fmt::format("it reports event {}, which the cell does not have", event.event);
  }
  const std::string& name = model.problem.events[event.event].name;
  if (model.events[event.event].robot != robot) {
    return fmt::format("it reports {}, which is an event of {}", name,
                       model.program.robots[model.events[event.event].robot].name);
  }
  if ((event.kind == Kind::Happened) == model.problem.events[event.event].controllable) {
    return fmt::format("it reports {} as an event that it {}", name,
                       event.kind == Kind::Happened ? "has executed without a request" : "waits for");
  }
  return std::nullopt;
}

}  // namespace

void Supervision::Parts::fail(RobotIndex robot, const std::string& why) {
  robots_[robot].request.reset();
  if (robots_[robot].fault().empty()) robots_[robot].fail(why);
}

bool Supervision::Parts::take(const RobotReport& report, Instant now) {
  const bool is_of_zones = report.touched_zones.empty() || report.hash != hash_ ||
                           report.touched_zones.back() < rules_.model().program.zones.size();
  if (malformed(report) || !is_of_zones) {
    ++counts_.malformed;
    return false;
  }
  const auto robot = record_.robotNamed(report.robot);
  if (!robot) {
    ++counts_.unknown_robots;
    return false;
  }
  RobotWatch& watch = robots_[*robot];
  watch.noticed(now);
  if (watch.judge(report.session, record_.robot(*robot).session, now, settings_.lease) ==
      RobotWatch::Session::Foreign) {
    ++counts_.wrong_sessions;
    return false;
  }
  if (!watch.hear(report, now)) {
    ++counts_.old_reports;
    return false;
  }
  if (report.hash != hash_) {
    watch.forgetPlace();  // by the zones of another artifact
    fail(*robot, fmt::format("it uses another artifact ({}, the supervisor has {}): load the same on both",
                             foreignText(report.hash.substr(0, 8)), hash_.substr(0, 8)));
  } else if (report.instance != 0 && report.instance != record_.instance()) {
    ++counts_.other_supervisors;
    fail(*robot, "it follows another supervisor, or a supervisor that lost its journal");
  } else if (mode() != SupervisorMode::Fault && !record_.robot(*robot).is_out) {
    findIntruders();  // before its events are written, because the disk may take long
    // A node that was started anew while its robot stands at home is as one that is heard for the first time.
    const bool is_at_home = record_.tuple()[*robot] == rules_.initial()[*robot];
    if (record_.robot(*robot).session == 0 || (isStrange(*robot) && is_at_home)) join(*robot);
    if (record_.robot(*robot).session == report.session) takeEvents(*robot, now);
  }
  settle(now);
  return true;
}

/// It has to stand where all begin.
void Supervision::Parts::join(RobotIndex robot) {
  RobotWatch& watch = robots_[robot];
  const bool stands = !watch.report().moving && watch.isFresh(settings_.lease) && watch.isLinked() &&
                      ports_.fits(robot, record_.tuple()[robot], watch.report().joints);
  if (stands && watch.fault().empty()) (void)record_.join(robot, watch.session(), 0);
}

void Supervision::Parts::takeEvents(RobotIndex robot, Instant now) {
  RobotWatch& watch = robots_[robot];
  for (const NumberedEvent& event : watch.report().events) {
    if (!watch.fault().empty() || !takeEvent(robot, event, now)) break;
  }
  watch.waits_since.reset();
  if (!is_confirmed_[robot] && watch.fault().empty()) {
    is_confirmed_[robot] = watch.report().instance == record_.instance() && watch.isFresh(settings_.lease) &&
                           watch.isLinked() &&
                           ports_.fits(robot, record_.tuple()[robot], watch.report().joints);
  }
  const char* end = endedBy(watch.report().condition);
  if (end != nullptr && !watch.isExcused()) fail(robot, end);
}

bool Supervision::Parts::takeEvent(RobotIndex robot, const NumberedEvent& event, Instant now) {
  RobotWatch& watch = robots_[robot];
  const auto& known = record_.robot(robot);
  const auto failed = [&](const std::string& why) {
    fail(robot, why);
    return false;
  };
  if (event.number <= known.acknowledged) {
    const bool is_other = std::any_of(
        known.recent.begin(), known.recent.end(),
        [&](const NumberedEvent& recent) { return recent.number == event.number && recent != event; });
    return !is_other || failed(fmt::format("SEQUENCE: its event {} was different before", event.number));
  }
  if (watch.request && watch.request->event == event) return true;
  if (event.number == 0) return failed("SEQUENCE: events count from 1");
  if (const auto objection = objectionTo(rules_.model(), robot, event)) return failed(*objection);
  if (event.kind == Kind::Withdrawn) return takeWithdrawal(robot, event);
  if (watch.request || event.number != known.acknowledged + 1) {
    return failed(fmt::format("SEQUENCE: its event {} was received, but {} is the next", event.number,
                              known.acknowledged + 1));
  }
  if (event.kind == Kind::Wanted) {
    watch.request = Request{event, watch.waits_since.value_or(now)};
    return true;
  }
  if (rules_.decide(record_.tuple(), event.event).verdict != automata::Decision::Verdict::Granted) {
    return failed(fmt::format("it reports {}, which is impossible at the place of its program",
                              rules_.model().problem.events[event.event].name));
  }
  if (!record_.carryOut(robot, event)) return false;
  turns_.booked(robot, zonesBookedBy(rules_.model().events[event.event]));
  return true;
}

bool Supervision::Parts::takeWithdrawal(RobotIndex robot, const NumberedEvent& event) {
  RobotWatch& watch = robots_[robot];
  const auto& known = record_.robot(robot);
  const NumberedEvent wanted{event.number - 1, Kind::Wanted, event.event};
  const bool was_waiting = watch.request && watch.request->event == wanted;
  const bool was_granted = event.number == known.acknowledged + 1 && !known.recent.empty() &&
                           known.recent.back() == wanted && rules_.undone(record_.tuple(), event.event);
  if (!was_waiting && !was_granted) {
    fail(robot, fmt::format("SEQUENCE: its event {} withdraws an event that it has not just requested",
                            event.number));
    return false;
  }
  // Where it wants another thing at once, it has waited for that as long.
  if (was_waiting) watch.waits_since = watch.request->since;
  watch.request.reset();
  if (was_granted) turns_.takenBack(robot, zonesBookedBy(rules_.model().events[event.event]));
  return record_.carryOut(robot, event);
}

}  // namespace cobot_command::cell
