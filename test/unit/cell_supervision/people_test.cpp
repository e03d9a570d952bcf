// What people ask of a supervisor: to hold, to finish, to recover a robot or to take it out.
#include "cell_programs.h"
#include "supervised_cell.h"

namespace cobot_command::cell {
namespace {

using test_support::handover;
using test_support::headOn;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST(AHold, grantsNothingNewAndLetsWhatHappensCount) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "HOME>");
  EXPECT_TRUE(cell.supervision->hold(true, cell.now).success);
  cell.robots[0].goOn();
  cell.ask(1);
  EXPECT_EQ(cell.mode(), SupervisorMode::Holding);
  EXPECT_EQ(cell.robot(1).reason, WaitReason::Holding);
  EXPECT_EQ(cell.zone(0).state, ZoneState::Free) << "a release is true whatever is held";
  cell.supervision->hold(false, cell.now);
  cell.exchange();
  EXPECT_EQ(cell.placeOf(1), "T1>");
}

TEST(Finishing, letsRobotsEndAtHome) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.supervision->finish(true, cell.now);
  cell.ask(1);
  EXPECT_EQ(cell.robot(1).reason, WaitReason::Holding);
  cell.bring(0, "HOME");
  cell.supervision->finish(false, cell.now);
  cell.exchange();
  EXPECT_EQ(cell.placeOf(1), "T1>");
}

TEST(ALostRobot, isTakenOutWhenAPersonConfirmsThatItsZonesAreClear) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.robots[0].touches = true;
  cell.bring(1, "T1>");
  cell.ask(1);
  EXPECT_FALSE(cell.supervision->confirmClear("RA", "me", false, cell.now).success) << "it is not lost";
  cell.now += 600ms;
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_THAT(cell.supervision->confirmClear("RA", "me", false, cell.now).message, HasSubstr("was in Z"));
  EXPECT_FALSE(cell.supervision->confirmClear("RA", "", true, cell.now).success);
  EXPECT_TRUE(cell.supervision->confirmClear("RA", "me", true, cell.now).success);
  EXPECT_EQ(cell.robot(0).state, RobotState::Out);
  EXPECT_EQ(cell.zone(0).owner, "RB");
  EventRobot again(cell.model(), 0, 999);
  cell.supervision->take(again.report(), cell.now);
  EXPECT_TRUE(cell.supervision->recover("RA", "HOME", "me", cell.now).success);
  EXPECT_EQ(cell.robot(0).state, RobotState::Ready);
}

TEST(ALostRobot, thatMovedWhenItWasHeardLastMayHaveGoneOn) {
  SupervisedCell cell(handover());
  cell.exchange();
  cell.bring(0, "T1>1");
  cell.robots[0].moving = true;
  cell.exchange();
  cell.now += 600ms;
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_THAT(cell.supervision->confirmClear("RA", "me", false, cell.now).message,
              HasSubstr("can have moved further"));
  EXPECT_EQ(cell.zone(0).state, ZoneState::Quarantined);
  EXPECT_TRUE(cell.supervision->confirmClear("RA", "me", true, cell.now).success);
}

TEST(Recovery, isRefusedWithTheReason) {
  SupervisedCell cell(headOn());
  cell.exchange();
  cell.bring(1, "W>1");
  cell.bring(0, "W>");
  cell.robots[0].condition = RobotCondition::Stopped;
  cell.exchange();
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault);
  cell.robots[0].condition = RobotCondition::Ok;
  cell.exchange();
  EXPECT_EQ(cell.robot(0).state, RobotState::Fault) << "latched until it is recovered";
  const auto refusal = [&](const char* robot, const char* place) {
    const auto answer = cell.supervision->recover(robot, place, "me", cell.now);
    EXPECT_FALSE(answer.success);
    return answer.message;
  };
  EXPECT_THAT(refusal("RX", "HOME"), HasSubstr("the cell has RA, RB"));
  EXPECT_THAT(refusal("RA", "W"), HasSubstr("another robot holds a zone"));
  cell.fits = false;
  EXPECT_THAT(refusal("RA", "HOME"), HasSubstr("is not at HOME"));
  cell.fits = true;
  EXPECT_THAT(refusal("RA", "W>1"), HasSubstr("RA, RB could not return home"));
  RobotReport report = cell.robots[0].report();
  report.touched_zones = {0};
  cell.supervision->take(report, cell.now);
  EXPECT_THAT(refusal("RA", "HOME"), HasSubstr("is in Z1, which it does not hold at HOME"));
  cell.robots[0].moving = true;
  cell.exchange();
  EXPECT_THAT(refusal("RA", "HOME"), HasSubstr("wait until it is at standstill"));
  cell.robots[0].moving = false;
  cell.exchange();
  EXPECT_TRUE(cell.supervision->recover("RA", "HOME", "me", cell.now).success);
}

TEST(ARobotAtHome, canBeTakenOut) {
  SupervisedCell cell(handover());
  cell.supervision->take(cell.robots[1].report(), cell.now);
  EXPECT_TRUE(cell.supervision->takeOut("RA", "me", cell.now).success);
  EXPECT_EQ(cell.mode(), SupervisorMode::Ready) << "nobody waits for it any more";
}

}  // namespace
}  // namespace cobot_command::cell
