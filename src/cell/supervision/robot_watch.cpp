#include "supervision/robot_watch.h"

#include <algorithm>

namespace cobot_command::cell {

RobotWatch::Session RobotWatch::judge(std::uint64_t session, std::uint64_t listened, Instant now,
                                      Duration lease) const {
  if (former_sessions_.count(session) != 0) return Session::Foreign;
  if (session == listened || (listened == 0 && session_ == 0)) return Session::Known;
  if (session == session_) return listened == 0 ? Session::Known : Session::New;
  const bool has_gone = heard_ ? isSilent(now, lease) : noticed_ && now > *noticed_ + lease;
  return has_gone ? Session::New : Session::Foreign;
}

bool RobotWatch::hear(const RobotReport& report, Instant now) {
  if (report.session == session_ && report.number <= report_.number) return false;
  if (report.session != session_) {
    if (session_ != 0) former_sessions_.insert(session_);
    session_ = report.session;
    highest_number_ = 0;
    // What was wrong was wrong with the node that is gone; who was let in by that one is lost until a person
    // lets this one in.
    fault_.clear();
    request.reset();
  }
  report_ = report;
  if (!isExcused()) excused_.reset();
  heard_ = now;
  if (!report.events.empty()) highest_number_ = std::max(highest_number_, report.events.back().number);
  return true;
}

void RobotWatch::joined() {
  fault_.clear();
  excused_ = report_.condition;
  request.reset();
}

void RobotWatch::forgetPlace() {
  report_.touched_zones.clear();
  request.reset();
}

bool RobotWatch::touches(ZoneIndex zone) const {
  return std::binary_search(report_.touched_zones.begin(), report_.touched_zones.end(), zone);
}

}  // namespace cobot_command::cell
