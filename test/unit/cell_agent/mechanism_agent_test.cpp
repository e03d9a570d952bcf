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
  artifact->hash = "abc";
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
    status_.hash = "abc";
    status_.instance = 4;
    status_.mode = SupervisorMode::Ready;
    status_.robots.resize(2);
    status_.robots[0].name = "RA";
    status_.robots[1].name = "PALLET";
    status_.robots[1].session = 7;
    status_.robots[1].place = "HOME";
  }

  void letIn() {
    measure(0.0, false);
    status_.robots[1].joins = 1;
    tell();
  }
  void tell() {
    status_.robots[1].report = report_.number;
    agent_->hear(status_, ++number_, now_);
    if (auto report = agent_->takeReport(now_)) report_ = *report;
    events_ = report_.events;
  }
  /// Grants all that was told.
  void grant() {
    ASSERT_FALSE(events_.empty());
    status_.robots[1].acknowledged = events_.back().number;
    now_ += std::chrono::milliseconds(50);
    tell();
  }
  void measure(double position, bool moving = true, int times = 1) {
    for (int i = 0; i < times; ++i) {
      now_ += std::chrono::milliseconds(50);
      agent_->measure(position, moving, now_);
    }
    report_ = *agent_->takeReport(now_);
    events_ = report_.events;
  }
  /// The events of what it does next, by kind.
  [[nodiscard]] std::vector<Kind> kinds() const {
    std::vector<Kind> kinds;
    for (const NumberedEvent& event : events_) kinds.push_back(event.kind);
    return kinds;
  }
  /// On its way in.
  void sendIn() {
    letIn();
    agent_->run(true);
    measure(0.0, false);
    grant();
    grant();
  }
  void bringIn() {
    letIn();
    agent_->run(true);
    measure(0.0, false);
    grant();  // the go
    grant();  // what has happened by itself
    measure(1.0, false, 2);
    grant();  // that it has arrived, and the go back
  }

  std::unique_ptr<MechanismAgent> agent_ = *MechanismAgent::of(palletArtifact(), "PALLET", 7);
  CellStatus status_;
  std::uint64_t number_ = 0;
  Instant now_{std::chrono::seconds(1)};
  RobotReport report_;
  std::vector<NumberedEvent> events_;
};

TEST_F(Pallet, isRefusedUnderAnotherName) {
  const auto none = MechanismAgent::of(palletArtifact(), "RA", 7);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error(), HasSubstr("no mechanism \"RA\", but PALLET"));
}

TEST_F(Pallet, tellsNothingBeforeItWasMeasured) {
  EXPECT_FALSE(agent_->takeReport(now_));
  agent_->measure(std::numeric_limits<double>::quiet_NaN(), false, now_);
  EXPECT_FALSE(agent_->takeReport(now_));
}

TEST_F(Pallet, staysAtHomeUntilItIsToRunAndLetGo) {
  letIn();
  EXPECT_THAT(events_, IsEmpty());
  agent_->run(true);
  measure(0.0, false);
  EXPECT_THAT(kinds(), ElementsAre(Kind::Wanted));
  EXPECT_EQ(agent_->target(), 0.0) << "it was not let go";
  grant();
  EXPECT_EQ(agent_->target(), 1.0);
}

TEST_F(Pallet, tellsOfABookingThatNobodyCanRefuse) {
  letIn();
  agent_->run(true);
  measure(0.0, false);
  grant();
  EXPECT_THAT(kinds(), ElementsAre(Kind::Happened)) << "let go, it enters by itself";
}

TEST_F(Pallet, hasArrivedWhenItWasMeasuredThereStandingTwice) {
  letIn();
  agent_->run(true);
  measure(0.0, false);
  grant();
  grant();
  measure(1.0, true, 3);
  EXPECT_EQ(agent_->place(), "IN>1") << "it moves still";
  measure(1.0, false);
  EXPECT_EQ(agent_->place(), "IN>1") << "once is not enough";
  measure(1.0, false);
  EXPECT_NE(agent_->place(), "IN>1");
}

TEST_F(Pallet, givesTheZoneBackBehindTheLastPieceThatTouchesIt) {
  bringIn();
  EXPECT_EQ(agent_->target(), 0.0);
  measure(0.6, true, 3);
  EXPECT_THAT(kinds(), IsEmpty());
  EXPECT_THAT(report_.touched_zones, ElementsAre(0));
  measure(0.4, true, 2);
  EXPECT_THAT(kinds(), ElementsAre(Kind::Happened));
  EXPECT_THAT(report_.touched_zones, IsEmpty());
  grant();
  measure(0.0, false, 2);
  EXPECT_EQ(agent_->cyclesDone(), 1);
}

TEST_F(Pallet, tellsThatItIsWhereItMayNotBeAndWhichZonesItIsInThere) {
  letIn();
  measure(0.6, true, 1);
  EXPECT_EQ(report_.condition, RobotCondition::Ok) << "the first may be of before";
  EXPECT_THAT(report_.touched_zones, ElementsAre(0)) << "but it may be there";
  measure(0.6, true, 1);
  EXPECT_EQ(report_.condition, RobotCondition::OffPath);
  EXPECT_THAT(report_.touched_zones, ElementsAre(0));
  measure(5.0, true, 1);
  EXPECT_THAT(report_.touched_zones, ElementsAre(0)) << "beyond all that is known it may be in any";
}

TEST_F(Pallet, hasToStayWhereItIsOnceItWasStoppedUntilItIsRecovered) {
  sendIn();
  measure(0.2);
  EXPECT_EQ(agent_->target(), 1.0);
  agent_->stop();
  measure(0.25);
  EXPECT_EQ(report_.condition, RobotCondition::Stopped);
  EXPECT_EQ(agent_->target(), 0.25) << "where it has come to rest";
  measure(0.0, false, 2);
  status_.robots[1].joins = 2;
  status_.robots[1].place = "HOME";
  agent_->run(false);
  tell();
  EXPECT_EQ(agent_->target(), 0.0);
  measure(0.0, false);
  EXPECT_EQ(report_.condition, RobotCondition::Ok);
}

TEST_F(Pallet, isToldToStayWhereItIsOnceItIsOutOfTheCell) {
  sendIn();
  measure(0.2);
  status_.robots[1].state = RobotState::Out;
  tell();
  EXPECT_EQ(agent_->target(), 0.2);
  // Its drive was off, and people have turned it.
  now_ += std::chrono::seconds(5);
  measure(0.7, false);
  EXPECT_EQ(agent_->target(), 0.7) << "and not back";
  EXPECT_THAT(report_.touched_zones, ElementsAre(0)) << "by where it is";
  agent_->stop();
  measure(0.7, false);
  EXPECT_EQ(agent_->target(), 0.7);
}

TEST_F(Pallet, isOffItsPathWhereItWasPutBackWhileItWasSilent) {
  sendIn();
  measure(0.4);
  now_ += std::chrono::seconds(5);
  measure(0.1);
  EXPECT_EQ(report_.condition, RobotCondition::OffPath);
  EXPECT_EQ(agent_->target(), 0.1);
}

TEST_F(Pallet, goesOnByItselfWhereItHasGoneOnWhileItWasSilent) {
  sendIn();
  measure(0.2);
  now_ += std::chrono::seconds(5);
  measure(0.4);
  EXPECT_EQ(report_.condition, RobotCondition::Ok);
  EXPECT_EQ(agent_->target(), 1.0);
}

TEST_F(Pallet, isOffItsPathWhenItTurnsRound) {
  sendIn();
  measure(0.4);
  measure(0.39, true, 2);
  EXPECT_EQ(report_.condition, RobotCondition::OffPath);
}

TEST_F(Pallet, doesNotGoOnWhereItIsRecoveredBeforeTheCellDoes) {
  sendIn();
  measure(0.2);
  agent_->stop();
  measure(0.2, false);
  status_.mode = SupervisorMode::Holding;
  status_.robots[1].joins = 2;
  status_.robots[1].place = agent_->place();
  tell();
  measure(0.2, false);
  EXPECT_EQ(report_.condition, RobotCondition::Ok);
  EXPECT_EQ(agent_->target(), 0.2);
  status_.mode = SupervisorMode::Running;
  tell();
  EXPECT_EQ(agent_->target(), 1.0);
}

TEST_F(Pallet, doesNotSetOutByALeaveOfBeforeTheCellWasHeld) {
  letIn();
  agent_->run(true);
  measure(0.0, false);
  status_.mode = SupervisorMode::Holding;
  grant();
  EXPECT_EQ(agent_->target(), 0.0);
  status_.mode = SupervisorMode::Running;
  tell();
  EXPECT_EQ(agent_->target(), 1.0);
}

TEST_F(Pallet, doesNotSetOutByALeaveThatANetworkHasKept) {
  letIn();
  agent_->run(true);
  measure(0.0, false);
  status_.robots[1].acknowledged = events_.back().number;
  const std::uint64_t old = report_.number;
  for (int i = 0; i < 20; ++i) measure(0.0, false);
  status_.robots[1].report = old;
  agent_->hear(status_, ++number_, now_);
  EXPECT_EQ(agent_->target(), 0.0) << "the state knows only a report of a second ago";
}

TEST_F(Pallet, staysStoppedWhereTheStopCameBehindWhatLetItGoOn) {
  sendIn();
  measure(0.2);
  const std::uint64_t before = report_.number;
  agent_->stop();
  status_.robots[1].joins = 2;
  status_.robots[1].place = agent_->place();
  status_.robots[1].report = before;
  agent_->hear(status_, ++number_, now_);
  measure(0.2, false);
  EXPECT_EQ(report_.condition, RobotCondition::Stopped);
  EXPECT_EQ(agent_->target(), 0.2);
}

TEST_F(Pallet, isNotToldToGoBackByWhatItHasRunOn) {
  sendIn();
  measure(0.2);
  agent_->stop();
  measure(0.204);
  measure(0.204, false);
  EXPECT_EQ(agent_->target(), 0.204);
}

TEST_F(Pallet, isNotOffItsPathByOneMeasurementThatIsWrong) {
  sendIn();
  measure(0.2);
  measure(0.4);
  measure(0.22, true, 2);
  EXPECT_EQ(report_.condition, RobotCondition::Ok);
}

TEST_F(Pallet, fallsSilentWhenNobodyMeasuresIt) {
  letIn();
  EXPECT_FALSE(agent_->takeReport(now_ + std::chrono::seconds(1)));
}

}  // namespace
}  // namespace cobot_command::cell
