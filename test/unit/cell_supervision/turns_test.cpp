// Robots that take turns on a zone, by a schedule (cell.md, M37): RB goes first.
#include "cell_programs.h"
#include "supervised_cell.h"
#include "supervision/zone_turns.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using test_support::handover;
using ::testing::ElementsAre;

SupervisionSettings takingTurns() {
  SupervisionSettings settings;
  settings.turns = {{1, 0}};
  return settings;
}

class Turns : public ::testing::Test {
 protected:
  Turns() { cell.exchange(); }

  void wait(Duration duration) {
    const Instant until = cell.now + duration;
    while (cell.now < until) cell.exchange();
  }

  SupervisedCell cell{handover(), Policy::Supervisor, takingTurns()};
};

TEST_F(Turns, areToldAsThePolicy) {
  EXPECT_EQ(cell.supervision->status(cell.now).policy, "schedule");
}

TEST_F(Turns, keepARobotBackThatCameFirstButIsSecond) {
  cell.bring(0, "T1>");
  cell.bring(1, "T1>");
  cell.ask(0);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Scheduled);
  EXPECT_THAT(cell.robot(0).blocked_by, ElementsAre("RB"));
  cell.ask(1);
  EXPECT_EQ(cell.placeOf(1), "T1>1");
  EXPECT_EQ(cell.robot(0).reason, WaitReason::ZoneHeld);
  cell.bring(1, "HOME>1");
  EXPECT_EQ(cell.placeOf(0), "T1>1");
}

TEST_F(Turns, passOverARobotThatStandsAtHomeAndAsksForNothing) {
  cell.bring(0, "T1>");
  cell.ask(0);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Scheduled) << "it may still come";
  wait(std::chrono::seconds(1));
  EXPECT_EQ(cell.placeOf(0), "T1>1");
}

TEST_F(Turns, comeRoundAgain) {
  for (int cycle = 0; cycle < 3; ++cycle) {
    cell.bring(0, "T1>");
    cell.bring(1, "T1>1");
    cell.ask(0);
    EXPECT_EQ(cell.robot(0).reason, WaitReason::ZoneHeld);
    cell.bring(1, "HOME");
    EXPECT_EQ(cell.placeOf(0), "T1>1");
    cell.bring(0, "HOME");
  }
}

TEST_F(Turns, areSuspendedBehindAFaultUntilAllAreHome) {
  cell.bring(0, "T1>");
  cell.bring(1, "T1>");
  cell.robots[1].condition = RobotCondition::Manual;
  cell.exchange();
  cell.robots[1].condition = RobotCondition::Ok;
  cell.exchange();
  cell.ask(0);
  EXPECT_EQ(cell.placeOf(0), "T1>1") << "the supervisor alone rules";
  cell.bring(0, "HOME");
  cell.bring(1, "HOME");
  cell.bring(0, "T1>");
  cell.ask(0);
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Scheduled) << "all were home";
}

TEST_F(Turns, keepNobodyBackForLongerThanAgingAllows) {
  cell.bring(1, "T1>");
  cell.bring(0, "T1>");
  cell.ask(0);
  wait(std::chrono::seconds(9));
  EXPECT_EQ(cell.robot(0).reason, WaitReason::Scheduled);
  wait(std::chrono::seconds(2));
  EXPECT_EQ(cell.placeOf(0), "T1>1");
}

TEST(ZoneTurns, giveATurnBackThatWasNotUsed) {
  ZoneTurns turns({{1, 0}});
  EXPECT_FALSE(turns.before(0, {0})) << "suspended at first";
  turns.beginAnew();
  EXPECT_EQ(turns.before(0, {0}), RobotIndex{1});
  turns.booked(1, {0});
  EXPECT_FALSE(turns.before(0, {0}));
  turns.takenBack(1, {0});
  EXPECT_EQ(turns.before(0, {0}), RobotIndex{1});
}

TEST(ZoneTurns, leaveThoseAloneThatHaveNone) {
  ZoneTurns turns({{1, 0}, {}});
  turns.beginAnew();
  EXPECT_FALSE(turns.before(2, {0})) << "it is not in the schedule";
  EXPECT_FALSE(turns.before(0, {1})) << "a zone that only one robot uses";
  EXPECT_EQ(turns.before(0, {1, 0}), RobotIndex{1});
}

}  // namespace
}  // namespace cobot_command::cell
