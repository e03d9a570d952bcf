#include "supervision/supervisor_diagnostics.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using Mode = cell::SupervisorMode;
using State = cell::RobotState;

unsigned char levelOf(Mode mode) {
  if (mode == Mode::Fault) return DiagnosticStatus::ERROR;
  return mode == Mode::Ready || mode == Mode::Running ? DiagnosticStatus::OK : DiagnosticStatus::WARN;
}

unsigned char levelOf(State state) {
  switch (state) {
    case State::Lost:
    case State::OffPath:
    case State::Fault:
      return DiagnosticStatus::ERROR;
    case State::Absent:
    case State::Manual:
      return DiagnosticStatus::WARN;
    default:
      return DiagnosticStatus::OK;
  }
}

std::string withText(const char* word, const std::string& text) {
  return text.empty() ? word : fmt::format("{}: {}", word, text);
}

}  // namespace

void Latencies::take(Duration latency) {
  latest_[count_ % latest_.size()] = latency;
  ++count_;
}

Duration Latencies::p99() const {
  std::vector<Duration> sorted(
      latest_.begin(), latest_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, latest_.size())));
  if (sorted.empty()) return {};
  const auto rank = static_cast<std::ptrdiff_t>((sorted.size() * 99 - 1) / 100);
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

void describeMode(DiagnosticStatusWrapper& status, const CellView& view) {
  status.summary(levelOf(view.status.mode),
                 withText(toString(view.status.mode), forPeople(view.status.diagnosis)));
  status.add("cell", forPeople(view.status.cell));
  status.add("hash", view.status.hash);
  status.add("policy", view.status.policy);
  status.add("epoch", view.status.epoch);
  status.add("events", view.status.events);
}

void describeRobots(DiagnosticStatusWrapper& status, const CellView& view) {
  status.summary(DiagnosticStatus::OK, "all robots report");
  for (const cell::RobotStatus& robot : view.status.robots) {
    const unsigned char level = levelOf(robot.state);
    if (level != DiagnosticStatus::OK) {
      status.mergeSummary(
          level, forPeople(fmt::format("{} is {}", robot.name, withText(toString(robot.state), robot.text))));
    }
    status.add(robot.name, fmt::format("{} at {}, last report {:.3f} s ago", toString(robot.state),
                                       robot.place, toSeconds(robot.report_age)));
  }
}

void describeZones(DiagnosticStatusWrapper& status, const CellView& view) {
  status.summary(DiagnosticStatus::OK, "no zone is occupied for long");
  for (const cell::ZoneStatus& zone : view.status.zones) {
    const std::string who = zone.owner.empty() ? "" : " by " + zone.owner;
    const std::string held =
        fmt::format("{}{} for {:.0f} s", toString(zone.state), who, toSeconds(zone.since));
    status.add(zone.name, held);
    const bool is_long = zone.state != cell::ZoneState::Free && zone.since > view.wait_timeout;
    if (is_long && !zone.waiting.empty()) {
      status.mergeSummary(DiagnosticStatus::WARN, forPeople(fmt::format("{} is {}, and {} waits", zone.name,
                                                                        held, zone.waiting.front())));
    } else if (zone.state == cell::ZoneState::Quarantined) {
      status.mergeSummary(DiagnosticStatus::WARN, forPeople(fmt::format("{} is {}", zone.name, held)));
    }
  }
}

void describeReports(DiagnosticStatusWrapper& status, const CellView& view) {
  const cell::SupervisionCounts& counts = view.counts;
  status.summary(DiagnosticStatus::OK, "all reports are valid");
  if (counts.malformed + counts.unknown_robots > 0) {
    status.summary(DiagnosticStatus::WARN, "some reports were malformed or of unknown robots");
  }
  if (counts.wrong_sessions > 0) {
    status.mergeSummary(DiagnosticStatus::WARN,
                        "some reports were of another session: two nodes for one robot, or a restarted node");
  }
  if (counts.other_supervisors > 0) {
    status.mergeSummary(DiagnosticStatus::ERROR, "some reports are for another supervisor");
  }
  if (!view.other.empty()) {
    status.mergeSummary(DiagnosticStatus::ERROR,
                        fmt::format("{} also publishes the state of this cell: stop one of the two",
                                    foreignText(view.other)));
  }
  status.add("malformed", counts.malformed);
  status.add("of unknown robots", counts.unknown_robots);
  status.add("of other sessions", counts.wrong_sessions);
  status.add("old", counts.old_reports);
  status.add("of other supervisors", counts.other_supervisors);
  status.add("answered within [ms], 99 of 100", toSeconds(view.p99) * 1e3);
}

SupervisorDiagnostics::SupervisorDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& self,
                                             Duration wait_timeout)
    : updater_(node, ros::NodeHandle(self, "diagnostic_updater")) {
  view_.wait_timeout = wait_timeout;
  updater_.setHardwareID("none");
  add("Mode", describeMode);
  add("Robots", describeRobots);
  add("Zones", describeZones);
  add("Reports", describeReports);
  timer_ =
      ros::NodeHandle(node).createSteadyTimer(ros::WallDuration(1.0), [this](const ros::SteadyTimerEvent&) {
        view_.p99 = latencies_.p99();
        updater_.force_update();
      });
}

void SupervisorDiagnostics::add(const char* task, Describe describe) {
  updater_.add(task, [this, describe](DiagnosticStatusWrapper& status) { describe(status, view_); });
}

void SupervisorDiagnostics::take(const cell::CellStatus& status, const cell::SupervisionCounts& counts) {
  view_.status = status;
  view_.counts = counts;
}

}  // namespace cobot_command::ros_adapter
