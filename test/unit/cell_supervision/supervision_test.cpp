#include "cobot_command/cell/supervision/supervision.h"

#include "cell_programs.h"
#include "supervised_cell.h"

namespace cobot_command::cell {
namespace {

using test_support::handover;
using test_support::headOn;
using test_support::iris;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace std::chrono_literals;

/// R1 and R2 in their own zones, R3 on its way, as in oracle 8.
void beginOracle8(SupervisedCell& cell) {
  cell.exchange();
  cell.bring(0, "W>1");
  cell.bring(1, "W>1");
  cell.bring(2, "W>");
}

TEST(ASupervisor, isReadyOnceAllRobotsHaveToldWhereTheyAre) {
  SupervisedCell cell(handover());
  EXPECT_EQ(cell.mode(), SupervisorMode::Starting);
  EXPECT_THAT(cell.supervision->status(cell.now).diagnosis, HasSubstr("RA, RB"));
  cell.supervision->take(cell.robots[0].report(), cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Starting);
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ASupervisor, waitsForARobotToWhichNothingCanBeSent) {
  SupervisedCell cell(handover());
  cell.robots[0].condition = RobotCondition::Unlinked;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Starting);
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  EXPECT_THAT(cell.robot(0).text, HasSubstr("no commands can be sent to it"));
  const PersonsAnswer answer = cell.supervision->recover("RA", "HOME", "me", cell.now);
  EXPECT_FALSE(answer.success);
  EXPECT_THAT(answer.message, HasSubstr("no commands can be sent to RA"));
  cell.robots[0].condition = RobotCondition::Ok;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ARobotToWhichNothingCanBeSent, isGrantedNothingUntilItIsLinkedAgain) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.robots[0].condition = RobotCondition::Unlinked;
  cell.ask(0);
  EXPECT_EQ(cell.placeOf(0), "HOME");
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  cell.bring(1, "T1>1");
  cell.robots[0].condition = RobotCondition::Ok;
  cell.exchange();
  EXPECT_EQ(cell.placeOf(0), "T1>") << "nobody has to recover it where it stands";
}

TEST(ASupervisor, waitsForARobotThatDoesNotStandAtHome) {
  SupervisedCell cell(handover());
  cell.fits = false;
  cell.exchange();
  EXPECT_EQ(cell.robot(0).state, RobotState::Absent);
  EXPECT_THAT(cell.robot(0).text, HasSubstr("is not at HOME"));
  cell.fits = true;
  cell.robots[0].moving = true;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Starting);
  cell.robots[0].moving = false;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

/// Else a program that is started where the cell is ready would end at once: its robot knows of no
/// supervisor.
TEST(ASupervisor, waitsForARobotThatHasNotReceivedItsState) {
  SupervisedCell cell(handover());
  EventRobot robot(cell.model(), 0, 100, 0);
  cell.supervision->take(robot.report(), cell.now);
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Starting);
  EXPECT_EQ(cell.robot(0).state, RobotState::Absent);
  EXPECT_EQ(cell.robot(0).text, "it has not received the state of this supervisor");
  EXPECT_EQ(cell.robot(1).state, RobotState::Ready);
  robot.hear(cell.supervision->status(cell.now));
  cell.supervision->take(robot.report(), cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ASupervisor, letsARobotJoinThatWasStartedAnewWithTheRightArtifact) {
  SupervisedCell cell(handover());
  RobotReport other = cell.robots[0].report();
  other.hash = "another";
  cell.supervision->take(other, cell.now);
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  cell.now += 600ms;
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EventRobot again(cell.model(), 0, 999);
  cell.supervision->take(again.report(), cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
}

TEST(ASupervisor, letsOneRobotAfterTheOtherIntoAZone) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  EXPECT_EQ(cell.zone(0).owner, "RA");
  cell.bring(1, "T1>");
  cell.ask(1);
  const RobotStatus waiting = cell.robot(1);
  EXPECT_EQ(waiting.state, RobotState::Waiting);
  EXPECT_EQ(waiting.reason, WaitReason::ZoneHeld);
  EXPECT_THAT(waiting.blocked_by, ElementsAre("RA"));
  EXPECT_EQ(waiting.place_in_queue, 1U);
  EXPECT_THAT(cell.zone(0).waiting, ElementsAre("RB"));
  cell.bring(0, "HOME>1");
  EXPECT_EQ(cell.placeOf(1), "T1>1");
  EXPECT_EQ(cell.zone(0).owner, "RB");
}

TEST(ASupervisor, answersAsInOracle8) {
  SupervisedCell cell(iris());
  beginOracle8(cell);
  cell.ask(2);
  EXPECT_EQ(cell.robot(2).reason, WaitReason::WouldBlock);
  EXPECT_THAT(cell.robot(2).blocked_by, ElementsAre("R1", "R2", "R3"));
  cell.ask(0);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::ZoneHeld);
  EXPECT_THAT(cell.robot(0).blocked_by, ElementsAre("R2"));
  cell.ask(1);
  EXPECT_EQ(cell.placeOf(1), "W>2");
  cell.bring(1, "HOME>1");
  EXPECT_EQ(cell.placeOf(2), "W>1") << "right after Z3 is free, while R2 still holds Z2";
  EXPECT_EQ(cell.zone(1).owner, "R2");
}

TEST(ASupervisor, tellsNothingThatIsNotInTheJournal) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.journal_is_full = true;
  cell.ask(0);
  EXPECT_EQ(cell.mode(), SupervisorMode::Fault);
  EXPECT_TRUE(cell.robots[0].waits());
  EXPECT_THAT(cell.supervision->status(cell.now).diagnosis, HasSubstr("journal cannot be written"));
  cell.journal_is_full = false;
  cell.exchange();
  EXPECT_EQ(cell.mode(), SupervisorMode::Fault) << "latched";
}

TEST(ASupervisor, carriesOutANumberOnce) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.robots[0].goOn();
  for (int time = 0; time < 1000; ++time) cell.supervision->take(cell.robots[0].report(), cell.now);
  EXPECT_EQ(cell.supervision->status(cell.now).events, 1U);
}

TEST(ASupervisor, hearsNothingOfReportsThatAreNone) {
  SupervisedCell cell(handover());
  cell.exchange();
  const auto drops = [&](const std::function<void(RobotReport&)>& change) {
    RobotReport report = cell.robots[0].report();
    change(report);
    const auto before = cell.supervision->counts().malformed;
    cell.supervision->take(report, cell.now);
    return cell.supervision->counts().malformed == before + 1;
  };
  EXPECT_TRUE(drops([](auto& report) { report.joints[3] = std::nan(""); }));
  EXPECT_TRUE(drops([](auto& report) { report.joints[3] = 1e300; }));
  EXPECT_TRUE(drops([](auto& report) { report.status_age = -1; }));
  EXPECT_TRUE(drops([](auto& report) { report.text = std::string(10000, 'x'); }));
  EXPECT_TRUE(drops([](auto& report) { report.text = "\xFF"; }));
  EXPECT_TRUE(drops([](auto& report) { report.robot.clear(); }));
  EXPECT_TRUE(drops([](auto& report) { report.session = 0; }));
  EXPECT_TRUE(drops([](auto& report) { report.events.resize(1000); }));
  EXPECT_TRUE(drops([](auto& report) { report.touched_zones = {2, 1}; }));
  EXPECT_TRUE(drops([](auto& report) { report.condition = static_cast<RobotCondition>(77); }));
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready);
  cell.now += 600ms;
  cell.supervision->tick(cell.now);
  EXPECT_EQ(cell.robot(0).state, RobotState::Lost);
}

/// A report of RA, changed, and what the robot is told about itself then.
std::string faultBehind(const std::function<void(RobotReport&)>& change) {
  SupervisedCell cell(headOn());
  cell.exchange();
  cell.bring(0, "W>1");
  RobotReport report = cell.robots[0].report();
  change(report);
  cell.supervision->take(report, cell.now);
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  EXPECT_EQ(cell.zone(0).owner, "RA") << "its zones stay";
  EXPECT_EQ(cell.zone(0).state, ZoneState::Quarantined);
  cell.bring(1, "W>");
  EXPECT_EQ(cell.robot(1).state, RobotState::Ready) << "the rest runs on";
  return cell.robot(0).text;
}

TEST(ARobotsReport, isAFaultWhereItCannotBeMeant) {
  using Kind = NumberedEvent::Kind;
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Wanted, 999}};
              }),
              HasSubstr("event 999"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Wanted, 9}};
              }),
              HasSubstr("an event of RB"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Happened, 2}};
              }),
              HasSubstr("executed without a request"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Wanted, 3}};
              }),
              HasSubstr("waits for"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{4, Kind::Wanted, 2}};
              }),
              HasSubstr("SEQUENCE"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{2, Kind::Wanted, 2}};
              }),
              HasSubstr("SEQUENCE"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Withdrawn, 2}};
              }),
              HasSubstr("SEQUENCE"));
  EXPECT_THAT(faultBehind([](auto& report) {
                report.events = {{3, Kind::Happened, 5}};
              }),
              HasSubstr("impossible at the place of its program"));
  EXPECT_THAT(faultBehind([](auto& report) { report.hash = "other"; }), HasSubstr("uses another artifact"));
  EXPECT_THAT(faultBehind([](auto& report) { report.instance = 8; }), HasSubstr("another supervisor"));
  EXPECT_THAT(faultBehind([](auto& report) { report.condition = RobotCondition::Error; }),
              HasSubstr("has an error"));
}

TEST(ARobotThatIsSilent, keepsItsZonesAndGetsThemBackByItself) {
  SupervisedCell cell(iris());
  beginOracle8(cell);
  cell.ask(0);
  cell.now += 600ms;
  for (RobotIndex robot : {0U, 2U}) cell.supervision->take(cell.robots[robot].report(), cell.now);
  EXPECT_EQ(cell.robot(1).state, RobotState::Lost);
  EXPECT_EQ(cell.zone(1).state, ZoneState::Quarantined);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Quarantined);
  EXPECT_THAT(cell.robot(0).blocked_by, ElementsAre("R2"));
  cell.exchange();
  EXPECT_EQ(cell.zone(1).state, ZoneState::Held);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::ZoneHeld);
}

TEST(ARobotWhoseNodeWasStartedAnew, isLostUntilAPersonHasRecoveredIt) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  EventRobot again(cell.model(), 0, 999);
  RobotReport late = cell.robots[0].report();
  cell.supervision->take(again.report(), cell.now);
  EXPECT_EQ(cell.supervision->counts().wrong_sessions, 1U)
      << "the first session counts as long as it is heard";
  cell.now += 600ms;
  cell.supervision->take(again.report(), cell.now);
  EXPECT_EQ(cell.robot(0).state, RobotState::Lost);
  EXPECT_THAT(cell.robot(0).text, HasSubstr("was restarted"));
  EXPECT_FALSE(cell.supervision->recover("RA", "T2", "me", cell.now).success);
  EXPECT_TRUE(cell.supervision->recover("RA", "HOME", "me", cell.now).success);
  EXPECT_EQ(cell.robot(0).state, RobotState::Ready);
  EXPECT_EQ(cell.zone(0).state, ZoneState::Free);
  late.number += 1000;
  cell.supervision->take(late, cell.now);
  EXPECT_EQ(cell.robot(0).session, 999U);
  EXPECT_EQ(cell.supervision->counts().wrong_sessions, 2U) << "what was late of the old one is only counted";
}

TEST(ABooking, isWithdrawnWhetherItWasGrantedOrNot) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.bring(1, "T1>");
  cell.ask(1);
  cell.robots[1].withdraw();
  cell.exchange();
  EXPECT_EQ(cell.robot(1).state, RobotState::Ready);
  cell.bring(0, "HOME>1");
  EXPECT_EQ(cell.zone(0).state, ZoneState::Free) << "nobody waits for it any more";
  // Granted, while the robot has not heard of it.
  cell.robots[1].goOn();
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_EQ(cell.zone(0).owner, "RB");
  cell.robots[1].withdraw();
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_EQ(cell.zone(0).state, ZoneState::Free);
  EXPECT_EQ(cell.robot(1).place, "T1>");
}

TEST(AnIntruder, StopsBothAndKeepsTheZoneFromOthers) {
  SupervisedCell cell(handover());
  cell.exchange();
  RobotReport report = cell.robots[1].report();
  report.condition = RobotCondition::Manual;
  report.touched_zones = {0};
  cell.supervision->take(report, cell.now);
  EXPECT_EQ(cell.robot(1).state, RobotState::Manual);
  EXPECT_EQ(cell.zone(0).state, ZoneState::Quarantined);
  EXPECT_THAT(cell.takeStopOrders(), IsEmpty()) << "the zone was free";
  cell.robots[0].goOn();
  cell.supervision->take(cell.robots[0].report(), cell.now);
  cell.robots[0].hear(cell.supervision->status(cell.now));
  cell.robots[0].goOn();
  cell.supervision->take(cell.robots[0].report(), cell.now);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Quarantined);
  cell.exchange();
  EXPECT_EQ(cell.placeOf(0), "T1>1") << "it is out of the zone again";
  report.number += 10;
  cell.supervision->take(report, cell.now);
  EXPECT_EQ(cell.mode(), SupervisorMode::Holding);
  const auto orders = cell.takeStopOrders();
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_THAT(orders[0].why, HasSubstr("INTRUSION: RB is in Z, which RA holds"));
}

TEST(Starvation, endsOneCycleBehindTheAgingTime) {
  // RC needs Z1 and Z2 at once; RA and RB each keep one of them busy, in turns.
  CellProgram program{
      "crowd",
      {"Z1", "Z2"},
      {test_support::thereAndBack("RA", "T", {test_support::book({0})}, {test_support::release(0)}),
       test_support::thereAndBack("RB", "T", {test_support::book({1})}, {test_support::release(1)}),
       test_support::thereAndBack("RC", "T", {test_support::book({0, 1})},
                                  {test_support::release(0), test_support::release(1)})}};
  SupervisionSettings settings;
  settings.aging = 2s;
  SupervisedCell cell(program, Policy::Supervisor, settings);
  cell.exchange();
  cell.bring(2, "T>");
  cell.bring(0, "T>1");
  cell.ask(2);
  const Instant asked = cell.now;
  // RA and RB go on by turns, so that never both zones are free.
  for (int turn = 0; cell.placeOf(2) == "T>" && turn < 1000; ++turn) {
    const RobotIndex robot = turn / 12 % 2 == 0 ? 1 : 0;
    cell.robots[robot].goOn();
    cell.exchange();
  }
  EXPECT_EQ(cell.placeOf(2), "T>1");
  EXPECT_LT(cell.now - asked, 2s + 2 * 12 * 50ms);
}

}  // namespace
}  // namespace cobot_command::cell
