// A pallet that enters the zone by itself once it is let go, as its own side tells and asks.
#include "cobot_command/cell/agent/mechanism_agent.h"

#include <limits>
#include <memory>

#include "cell_programs.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = NumberedEvent::Kind;

/// Positions in metres: at home 0, in the zone from 0.5 on, and at 1 IN.
std::shared_ptr<const Artifact> palletArtifact() {
  auto artifact = std::make_shared<Artifact>();
  artifact->digest = "abc";
  artifact->program = test_support::pallet();
  artifact->robots.resize(1);
  ArtifactMechanism& made = artifact->mechanisms.emplace_back();
  made.stations = {{0.0, {}}, {1.0, {0}}};
  made.paths.resize(2);
  made.paths[0].pieces = {{0.0, 0.5, {}}, {0.5, 1.0, {0}}, {1.0, 1.0, {0}}};
  made.paths[0].places = {{0, 1}};
  made.paths[1].pieces = {{1.0, 0.5, {0}}, {0.5, 0.0, {}}, {0.0, 0.0, {}}};
  made.paths[1].places = {{0, 0}};
  return artifact;
}

class Pallet : public ::testing::Test {
 protected:
  Pallet() {
    status.hash = "abc";
    status.instance = 4;
    status.mode = SupervisorMode::Ready;
    status.robots.resize(2);
    status.robots[0].name = "RA";
    status.robots[1].name = "PALLET";
    status.robots[1].session = 7;
    status.robots[1].place = "HOME";
  }

  void letIn() {
    measure(0.0, false);
    status.robots[1].joins = 1;
    tell();
  }
  void tell() {
    status.robots[1].report = report.number;
    agent->hear(status, ++number, now);
    if (const auto newest = agent->takeReport(now)) report = *newest;
    events = report.events;
  }
  /// Grants all that was told.
  void grant() {
    ASSERT_FALSE(events.empty());
    status.robots[1].acknowledged = events.back().number;
    now += std::chrono::milliseconds(50);
    tell();
  }
  void measure(double position, bool moving = true, int times = 1) {
    for (int i = 0; i < times; ++i) {
      now += std::chrono::milliseconds(50);
      agent->measure(position, moving, now);
    }
    report = *agent->takeReport(now);
    events = report.events;
  }
  /// The events of what it does next, by kind.
  [[nodiscard]] std::vector<Kind> kinds() const {
    std::vector<Kind> kinds;
    for (const NumberedEvent& event : events) kinds.push_back(event.kind);
    return kinds;
  }
  /// On its way in.
  void sendIn() {
    letIn();
    agent->run(true);
    measure(0.0, false);
    grant();
    grant();
  }
  void bringIn() {
    letIn();
    agent->run(true);
    measure(0.0, false);
    grant();  // the go
    grant();  // what has happened by itself
    measure(1.0, false, 2);
    grant();  // that it has arrived, and the go back
  }

  std::unique_ptr<MechanismAgent> agent = *MechanismAgent::of(palletArtifact(), "PALLET", 7);
  CellStatus status;
  std::uint64_t number = 0;
  Instant now{std::chrono::seconds(1)};
  RobotReport report;
  std::vector<NumberedEvent> events;
};

TEST_F(Pallet, isRefusedUnderAnotherName) {
  const auto none = MechanismAgent::of(palletArtifact(), "RA", 7);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("no mechanism \"RA\"; it has PALLET"));
}

TEST_F(Pallet, tellsNothingBeforeItWasMeasured) {
  EXPECT_FALSE(agent->takeReport(now));
  agent->measure(std::numeric_limits<double>::quiet_NaN(), false, now);
  EXPECT_FALSE(agent->takeReport(now));
}

TEST_F(Pallet, staysAtHomeUntilItIsToRunAndLetGo) {
  letIn();
  EXPECT_THAT(events, IsEmpty());
  agent->run(true);
  measure(0.0, false);
  EXPECT_THAT(kinds(), ElementsAre(Kind::Wanted));
  EXPECT_EQ(agent->target(), 0.0) << "it was not let go";
  grant();
  EXPECT_EQ(agent->target(), 1.0);
}

TEST_F(Pallet, tellsOfABookingThatNobodyCanRefuse) {
  letIn();
  agent->run(true);
  measure(0.0, false);
  grant();
  EXPECT_THAT(kinds(), ElementsAre(Kind::Happened)) << "let go, it enters by itself";
}

TEST_F(Pallet, hasArrivedWhenItWasMeasuredThereStandingTwice) {
  letIn();
  agent->run(true);
  measure(0.0, false);
  grant();
  grant();
  measure(1.0, true, 3);
  EXPECT_EQ(agent->place(), "IN>1") << "it moves still";
  measure(1.0, false);
  EXPECT_EQ(agent->place(), "IN>1") << "once is not enough";
  measure(1.0, false);
  EXPECT_NE(agent->place(), "IN>1");
}

TEST_F(Pallet, givesTheZoneBackBehindTheLastPieceThatTouchesIt) {
  bringIn();
  EXPECT_EQ(agent->target(), 0.0);
  measure(0.6, true, 3);
  EXPECT_THAT(kinds(), IsEmpty());
  EXPECT_THAT(report.touched_zones, ElementsAre(0));
  measure(0.4, true, 2);
  EXPECT_THAT(kinds(), ElementsAre(Kind::Happened));
  EXPECT_THAT(report.touched_zones, IsEmpty());
  grant();
  measure(0.0, false, 2);
  EXPECT_EQ(agent->cyclesDone(), 1);
}

TEST_F(Pallet, tellsThatItIsWhereItMayNotBeAndWhichZonesItIsInThere) {
  letIn();
  measure(0.6, true, 1);
  EXPECT_EQ(report.condition, RobotCondition::Ok) << "the first may be of before";
  EXPECT_THAT(report.touched_zones, ElementsAre(0)) << "but it may be there";
  measure(0.6, true, 1);
  EXPECT_EQ(report.condition, RobotCondition::OffPath);
  EXPECT_THAT(report.touched_zones, ElementsAre(0));
  measure(5.0, true, 1);
  EXPECT_THAT(report.touched_zones, ElementsAre(0)) << "beyond all that is known it may be in any";
}

TEST_F(Pallet, hasToStayWhereItIsOnceItWasStoppedUntilItIsRecovered) {
  sendIn();
  measure(0.2);
  EXPECT_EQ(agent->target(), 1.0);
  agent->stop();
  measure(0.25);
  EXPECT_EQ(report.condition, RobotCondition::Stopped);
  EXPECT_EQ(agent->target(), 0.25) << "where it has come to rest";
  measure(0.0, false, 2);
  status.robots[1].joins = 2;
  status.robots[1].place = "HOME";
  agent->run(false);
  tell();
  EXPECT_EQ(agent->target(), 0.0);
  measure(0.0, false);
  EXPECT_EQ(report.condition, RobotCondition::Ok);
}

TEST_F(Pallet, isToldToStayWhereItIsOnceItIsOutOfTheCell) {
  sendIn();
  measure(0.2);
  status.robots[1].state = RobotState::Out;
  tell();
  EXPECT_EQ(agent->target(), 0.2);
  // Its drive was off, and people have turned it.
  now += std::chrono::seconds(5);
  measure(0.7, false);
  EXPECT_EQ(agent->target(), 0.7) << "and not back";
  EXPECT_THAT(report.touched_zones, ElementsAre(0)) << "by where it is";
  agent->stop();
  measure(0.7, false);
  EXPECT_EQ(agent->target(), 0.7);
}

TEST_F(Pallet, isOffItsPathWhereItWasPutBackWhileItWasSilent) {
  sendIn();
  measure(0.4);
  now += std::chrono::seconds(5);
  measure(0.1);
  EXPECT_EQ(report.condition, RobotCondition::OffPath);
  EXPECT_EQ(agent->target(), 0.1);
}

TEST_F(Pallet, goesOnByItselfWhereItHasGoneOnWhileItWasSilent) {
  sendIn();
  measure(0.2);
  now += std::chrono::seconds(5);
  measure(0.4);
  EXPECT_EQ(report.condition, RobotCondition::Ok);
  EXPECT_EQ(agent->target(), 1.0);
}

TEST_F(Pallet, isOffItsPathWhenItTurnsRound) {
  sendIn();
  measure(0.4);
  measure(0.39, true, 2);
  EXPECT_EQ(report.condition, RobotCondition::OffPath);
}

TEST_F(Pallet, doesNotGoOnWhereItIsRecoveredBeforeTheCellDoes) {
  sendIn();
  measure(0.2);
  agent->stop();
  measure(0.2, false);
  status.mode = SupervisorMode::Holding;
  status.robots[1].joins = 2;
  status.robots[1].place = agent->place();
  tell();
  measure(0.2, false);
  EXPECT_EQ(report.condition, RobotCondition::Ok);
  EXPECT_EQ(agent->target(), 0.2);
  status.mode = SupervisorMode::Running;
  tell();
  EXPECT_EQ(agent->target(), 1.0);
}

TEST_F(Pallet, doesNotSetOutByALeaveOfBeforeTheCellWasHeld) {
  letIn();
  agent->run(true);
  measure(0.0, false);
  status.mode = SupervisorMode::Holding;
  grant();
  EXPECT_EQ(agent->target(), 0.0);
  status.mode = SupervisorMode::Running;
  tell();
  EXPECT_EQ(agent->target(), 1.0);
}

TEST_F(Pallet, doesNotSetOutByALeaveThatANetworkHasKept) {
  letIn();
  agent->run(true);
  measure(0.0, false);
  status.robots[1].acknowledged = events.back().number;
  const std::uint64_t old = report.number;
  for (int i = 0; i < 20; ++i) measure(0.0, false);
  status.robots[1].report = old;
  agent->hear(status, ++number, now);
  EXPECT_EQ(agent->target(), 0.0) << "the state knows only a report of a second ago";
}

TEST_F(Pallet, staysStoppedWhereTheStopCameBehindWhatLetItGoOn) {
  sendIn();
  measure(0.2);
  const std::uint64_t before = report.number;
  agent->stop();
  status.robots[1].joins = 2;
  status.robots[1].place = agent->place();
  status.robots[1].report = before;
  agent->hear(status, ++number, now);
  measure(0.2, false);
  EXPECT_EQ(report.condition, RobotCondition::Stopped);
  EXPECT_EQ(agent->target(), 0.2);
}

TEST_F(Pallet, isNotToldToGoBackByWhatItHasRunOn) {
  sendIn();
  measure(0.2);
  agent->stop();
  measure(0.204);
  measure(0.204, false);
  EXPECT_EQ(agent->target(), 0.204);
}

TEST_F(Pallet, isNotOffItsPathByOneMeasurementThatIsWrong) {
  sendIn();
  measure(0.2);
  measure(0.4);
  measure(0.22, true, 2);
  EXPECT_EQ(report.condition, RobotCondition::Ok);
}

TEST_F(Pallet, fallsSilentWhenNobodyMeasuresIt) {
  letIn();
  EXPECT_FALSE(agent->takeReport(now + std::chrono::seconds(1)));
}

}  // namespace
}  // namespace cobot_command::cell
