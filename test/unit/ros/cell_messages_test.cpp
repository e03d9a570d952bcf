// What robots of a cell and their supervisor tell each other, over the wire and back.
#include "cell/cell_messages.h"

#include <gmock/gmock.h>
#include <ros/time.h>

#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

using cell::NumberedEvent;

cell::RobotReport someReport() {
  cell::RobotReport report;
  report.robot = "RA";
  report.hash = "abc";
  report.session = 17;
  report.instance = 4;
  report.number = 9;
  report.events = {{1, NumberedEvent::Kind::Wanted, 3},
                   {2, NumberedEvent::Kind::Happened, 4},
                   {3, NumberedEvent::Kind::Withdrawn, 5}};
  report.place = "HOME>P +1";
  report.joints = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  report.status_age = 0.02;
  report.condition = cell::RobotCondition::Paused;
  report.moving = true;
  report.touched_zones = {0, 2};
  report.text = "it waits";
  return report;
}

cell::CellStatus someStatus() {
  cell::CellStatus status;
  status.cell = "head_on";
  status.hash = "abc";
  status.instance = 4;
  status.epoch = 2;
  status.events = 100;
  status.mode = cell::SupervisorMode::Running;
  status.policy = "supervisor";
  status.is_finishing = true;
  cell::RobotStatus robot;
  robot.name = "RA";
  robot.state = cell::RobotState::Waiting;
  robot.session = 17;
  robot.acknowledged = 3;
  robot.joins = 1;
  robot.place = "HOME";
  robot.reason = cell::WaitReason::ZoneHeld;
  robot.blocked_by = {"RB"};
  robot.place_in_queue = 1;
  robot.waiting = fromSeconds(1.5);
  robot.report_age = fromSeconds(0.25);
  robot.text = "a sentence";
  status.robots = {robot};
  status.zones = {{"Z1", {"RA", "RB"}, cell::ZoneState::Quarantined, "RB", fromSeconds(2), {"RA"}}};
  status.diagnosis = "another sentence";
  return status;
}

/// Messages have stamps, for people.
class CellMessages : public ::testing::Test {
 protected:
  CellMessages() { ros::Time::init(); }
};

TEST_F(CellMessages, aReportComesBackAsItWas) {
  const cell::RobotReport report = someReport();
  const cell::RobotReport back = toReport(toMessage(report));
  EXPECT_EQ(back.robot, report.robot);
  EXPECT_EQ(back.hash, report.hash);
  EXPECT_EQ(back.session, report.session);
  EXPECT_EQ(back.instance, report.instance);
  EXPECT_EQ(back.number, report.number);
  EXPECT_EQ(back.events, report.events);
  EXPECT_EQ(back.place, report.place);
  EXPECT_EQ(back.joints, report.joints);
  EXPECT_EQ(back.status_age, report.status_age);
  EXPECT_EQ(back.condition, report.condition);
  EXPECT_EQ(back.moving, report.moving);
  EXPECT_EQ(back.touched_zones, report.touched_zones);
  EXPECT_EQ(back.text, report.text);
}

TEST_F(CellMessages, aStateComesBackAsItWas) {
  const cell::CellStatus status = someStatus();
  const auto message = toMessage(status, 5);
  EXPECT_EQ(message.number, 5U);
  const cell::CellStatus back = toStatus(message);
  EXPECT_EQ(std::tie(back.cell, back.hash, back.instance, back.epoch, back.events, back.mode, back.policy,
                     back.is_finishing, back.diagnosis),
            std::tie(status.cell, status.hash, status.instance, status.epoch, status.events, status.mode,
                     status.policy, status.is_finishing, status.diagnosis));
  ASSERT_EQ(back.robots.size(), 1U);
  const cell::RobotStatus& robot = back.robots.front();
  const cell::RobotStatus& told = status.robots.front();
  EXPECT_EQ(
      std::tie(robot.name, robot.state, robot.session, robot.acknowledged, robot.joins, robot.place,
               robot.reason, robot.blocked_by, robot.place_in_queue, robot.waiting, robot.report_age,
               robot.text),
      std::tie(told.name, told.state, told.session, told.acknowledged, told.joins, told.place, told.reason,
               told.blocked_by, told.place_in_queue, told.waiting, told.report_age, told.text));
  ASSERT_EQ(back.zones.size(), 1U);
  const cell::ZoneStatus& zone = back.zones.front();
  EXPECT_EQ(zone.name, "Z1");
  EXPECT_EQ(zone.users, (std::vector<std::string>{"RA", "RB"}));
  EXPECT_EQ(zone.state, cell::ZoneState::Quarantined);
  EXPECT_EQ(zone.owner, "RB");
  EXPECT_EQ(zone.since, fromSeconds(2));
  EXPECT_EQ(zone.waiting, std::vector<std::string>{"RA"});
}

TEST_F(CellMessages, numbersThatStandForNothingGrantNothing) {
  auto message = toMessage(someStatus(), 1);
  message.mode = 200;
  message.robots.front().state = 200;
  message.robots.front().reason = 200;
  message.zones.front().state = 200;
  const cell::CellStatus status = toStatus(message);
  EXPECT_EQ(status.mode, cell::SupervisorMode::Fault);
  EXPECT_EQ(status.robots.front().state, cell::RobotState::Fault);
  EXPECT_EQ(status.robots.front().reason, cell::WaitReason::Holding);
  EXPECT_EQ(status.zones.front().state, cell::ZoneState::Quarantined);
}

TEST_F(CellMessages, anEventOfNoKindIsOneThatNoCellHas) {
  auto message = toMessage(someReport());
  message.events.front().kind = 7;
  const auto event = toReport(message).events.front();
  EXPECT_EQ(event.event, std::numeric_limits<std::uint32_t>::max());
  message.condition = 99;
  EXPECT_EQ(toReport(message).condition, cell::RobotCondition::Error);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
