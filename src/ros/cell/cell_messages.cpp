#include "cell/cell_messages.h"

#include <algorithm>
#include <limits>

#include <ros/time.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using EventMessage = cobot_command::CellEvent;
using ReportMessage = cobot_command::CellReport;

/// Of an enumeration whose numbers are those of the message.
template <class Kind>
Kind enumOf(std::uint8_t number, Kind last, Kind otherwise) {
  return number <= static_cast<std::uint8_t>(last) ? static_cast<Kind>(number) : otherwise;
}

ros::Duration toMessage(Duration duration) {
  return ros::Duration(toSeconds(duration));
}
Duration toDuration(const ros::Duration& duration) {
  return Duration(duration.toNSec());
}

EventMessage toMessage(const cell::NumberedEvent& event) {
  EventMessage message;
  message.number = event.number;
  message.kind = static_cast<std::uint8_t>(event.kind);
  message.event = static_cast<std::uint32_t>(event.event);
  return message;
}

/// A kind that there is not becomes an event that there is not.
cell::NumberedEvent toEvent(const EventMessage& message) {
  using Kind = cell::NumberedEvent::Kind;
  const bool is_known = message.kind <= EventMessage::WITHDRAWN;
  return {message.number, is_known ? static_cast<Kind>(message.kind) : Kind::Wanted,
          is_known ? message.event : std::numeric_limits<std::uint32_t>::max()};
}

cobot_command::CellRobot toMessage(const cell::RobotStatus& robot) {
  cobot_command::CellRobot message;
  message.name = robot.name;
  message.state = static_cast<std::uint8_t>(robot.state);
  message.session = robot.session;
  message.acknowledged = robot.acknowledged;
  message.joins = robot.joins;
  message.place = robot.place;
  message.reason = static_cast<std::uint8_t>(robot.reason);
  message.blocked_by = robot.blocked_by;
  message.place_in_queue = robot.place_in_queue;
  message.waiting = toMessage(robot.waiting);
  message.report = robot.report;
  message.report_age = toMessage(robot.report_age);
  message.text = forPeople(robot.text);
  return message;
}

cell::RobotStatus toRobot(const cobot_command::CellRobot& message) {
  cell::RobotStatus robot;
  robot.name = message.name;
  robot.state = enumOf(message.state, cell::RobotState::Out, cell::RobotState::Fault);
  robot.session = message.session;
  robot.acknowledged = message.acknowledged;
  robot.joins = message.joins;
  robot.place = message.place;
  robot.reason = enumOf(message.reason, cell::WaitReason::Scheduled, cell::WaitReason::Holding);
  robot.blocked_by = message.blocked_by;
  robot.place_in_queue = message.place_in_queue;
  robot.waiting = toDuration(message.waiting);
  robot.report = message.report;
  robot.report_age = toDuration(message.report_age);
  robot.text = forPeople(message.text);
  return robot;
}

cobot_command::CellZone toMessage(const cell::ZoneStatus& zone) {
  cobot_command::CellZone message;
  message.name = zone.name;
  message.users = zone.users;
  message.state = static_cast<std::uint8_t>(zone.state);
  message.owner = zone.owner;
  message.since = toMessage(zone.since);
  message.waiting = zone.waiting;
  return message;
}

cell::ZoneStatus toZone(const cobot_command::CellZone& message) {
  cell::ZoneStatus zone;
  zone.name = message.name;
  zone.users = message.users;
  zone.state = enumOf(message.state, cell::ZoneState::Quarantined, cell::ZoneState::Quarantined);
  zone.owner = message.owner;
  zone.since = toDuration(message.since);
  zone.waiting = message.waiting;
  return zone;
}

}  // namespace

ReportMessage toMessage(const cell::RobotReport& report) {
  ReportMessage message;
  message.header.stamp = ros::Time::now();
  message.robot = report.robot;
  message.hash = report.hash;
  message.session = report.session;
  message.instance = report.instance;
  message.number = report.number;
  for (const cell::NumberedEvent& event : report.events) message.events.push_back(toMessage(event));
  message.place = report.place;
  std::copy(report.joints.begin(), report.joints.end(), message.joints.begin());
  message.status_age = report.status_age;
  message.condition = static_cast<std::uint8_t>(report.condition);
  message.moving = report.moving ? 1 : 0;
  message.touched_zones = report.touched_zones;
  message.text = forPeople(report.text);
  return message;
}

cell::RobotReport toReport(const ReportMessage& message) {
  cell::RobotReport report;
  report.robot = message.robot;
  report.hash = message.hash;
  report.session = message.session;
  report.instance = message.instance;
  report.number = message.number;
  for (const EventMessage& event : message.events) report.events.push_back(toEvent(event));
  report.place = message.place;
  std::copy(message.joints.begin(), message.joints.end(), report.joints.begin());
  report.status_age = message.status_age;
  report.condition = enumOf(message.condition, cell::RobotCondition::Unlinked, cell::RobotCondition::Error);
  report.moving = message.moving != 0;
  report.touched_zones = message.touched_zones;
  report.text = forPeople(message.text);
  return report;
}

cobot_command::CellState toMessage(const cell::CellStatus& status, std::uint64_t number) {
  cobot_command::CellState message;
  message.header.stamp = ros::Time::now();
  message.cell = status.cell;
  message.hash = status.hash;
  message.instance = status.instance;
  message.epoch = status.epoch;
  message.number = number;
  message.events = status.events;
  message.mode = static_cast<std::uint8_t>(status.mode);
  message.policy = status.policy;
  message.finishing = static_cast<std::uint8_t>(status.is_finishing);
  for (const cell::RobotStatus& robot : status.robots) message.robots.push_back(toMessage(robot));
  for (const cell::ZoneStatus& zone : status.zones) message.zones.push_back(toMessage(zone));
  message.diagnosis = forPeople(status.diagnosis);
  return message;
}

cell::CellStatus toStatus(const cobot_command::CellState& message) {
  cell::CellStatus status;
  status.cell = message.cell;
  status.hash = message.hash;
  status.instance = message.instance;
  status.epoch = message.epoch;
  status.events = message.events;
  status.mode = enumOf(message.mode, cell::SupervisorMode::Fault, cell::SupervisorMode::Fault);
  status.policy = message.policy;
  status.is_finishing = message.finishing != 0;
  for (const cobot_command::CellRobot& robot : message.robots) status.robots.push_back(toRobot(robot));
  for (const cobot_command::CellZone& zone : message.zones) status.zones.push_back(toZone(zone));
  status.diagnosis = forPeople(message.diagnosis);
  return status;
}

}  // namespace cobot_command::ros_adapter
