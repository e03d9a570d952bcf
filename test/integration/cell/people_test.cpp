// What people do to robots while the cell runs: cancel, hold, stop, and move an arm.
#include <cmath>

#include "run_rig.h"

#include "cobot_command/common/units.h"

namespace cobot_command::trial {
namespace {

using cell::RobotState;
using cell::SupervisorMode;
using cell::WaitReason;
using ::testing::HasSubstr;

/// How far the first joint is from the path, on which it does not move in the handover.
double turned(RunRig& rig, cell::RobotIndex robot) {
  return std::abs(radToDeg(rig.robot(robot).state().joints[0]));
}

TEST(AGoalThatIsCancelledWhileItWaits, takesItsBookingBack) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(1).reason == WaitReason::ZoneHeld && !rig.isMoving(1); }));
  const std::string place = rig.of(1).place;
  rig.robot(1).cancel(rig.robot(1).lastGoal());
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(1).hasEnded(); }, 1s));
  EXPECT_EQ(rig.robot(1).lastOutcome()->ending, blocks::Ending::CommandAborted);
  EXPECT_TRUE(rig.ends(0));
  rig.pass(2s);
  EXPECT_EQ(rig.of(1).place, place);
  EXPECT_EQ(rig.zone(0).owner, "");
  EXPECT_FALSE(rig.isMoving(1));
  rig.order(1, 1);
  EXPECT_TRUE(rig.ends(1));
}

TEST(AGoalThatIsCancelledInAZone, leavesItToItsRobotUntilThatWasRecovered) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).cancel(rig.robot(0).lastGoal());
  rig.pass(10s);
  EXPECT_FALSE(rig.isMoving(0));
  EXPECT_TRUE(rig.isIn(0, 0));
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  EXPECT_FALSE(rig.isIn(1, 0));
  rig.order(0, 1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 2s));
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kRecoveryNeeded);

  const auto recovered = rig.supervision().recover("RA", rig.of(0).place, "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

TEST(AHold, letsSentFramesEndAndGrantsNothingUntilItIsOver) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(2);
  for (int i = 0; i < 12; ++i) {
    rig.pass(std::chrono::milliseconds(700 + 370 * (i % 5)));
    rig.supervision().hold(true, rig.trial->now());
    rig.pass(100ms);
    const auto sent = std::pair(rig.robot(0).scripts().size(), rig.robot(1).scripts().size());
    rig.pass(8s);
    EXPECT_EQ(std::pair(rig.robot(0).scripts().size(), rig.robot(1).scripts().size()), sent);
    EXPECT_FALSE(rig.isMoving(0) || rig.isMoving(1));
    rig.supervision().hold(false, rig.trial->now());
  }
  EXPECT_TRUE(rig.endsAll());
}

TEST(AStopOfTheCell, standsAllRobotsAndLeavesThemTheirZones) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.supervision().stop(rig.trial->now());
  rig.pass(1s);
  EXPECT_FALSE(rig.isMoving(0) || rig.isMoving(1));
  EXPECT_TRUE(rig.isIn(0, 0)) << "it was stopped on its way";
  EXPECT_EQ(rig.zone(0).owner, "RA");
  rig.supervision().hold(false, rig.trial->now());
  rig.pass(5s);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  for (const cell::RobotIndex robot : {0U, 1U}) {
    const auto recovered =
        rig.supervision().recover(rig.robot(robot).name(), rig.of(robot).place, "me", rig.trial->now());
    ASSERT_TRUE(recovered.success) << recovered.message;
  }
  rig.pass(1s);
  for (const cell::RobotIndex robot : {0U, 1U}) rig.order(robot, 1);
  EXPECT_TRUE(rig.endsAll());
}

/// RA stands at T1, in the zone, and its goal is done.
void bringIntoTheZone(RunRig& rig) {
  ASSERT_TRUE(rig.trial->start());
  rig.order(0, 1, {"T1"});
  ASSERT_TRUE(rig.ends(0));
  rig.order(1, 1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(1).reason == WaitReason::ZoneHeld && !rig.isMoving(1); }));
}

/// Two frames of the status stream, and what is left of a step of the clock.
constexpr Duration kTwoFrames = 2 * 15ms + 2ms;

TEST(ARobotThatIsMovedAtItsStationInAZone, isToldOfWithinTwoFramesAndKeepsTheZone) {
  RunRig rig(artifactOf("handover"));
  bringIntoTheZone(rig);
  rig.looks_at_zones = false;
  rig.commandByOther(0, {"PTP(\"JPP\",10,45,60,-15,90,0,5,200,0,false)"});
  ASSERT_TRUE(rig.passUntil([&] { return turned(rig, 0) > 0.5; }, 5s));
  const Instant left = rig.trial->now();
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(0).state == RobotState::OffPath; }, 1s));
  EXPECT_LE(rig.trial->now() - left, kTwoFrames);
  rig.pass(20s);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_EQ(rig.of(1).reason, WaitReason::Quarantined);
  EXPECT_FALSE(rig.isIn(1, 0));
  EXPECT_FALSE(rig.supervision().recover("RA", "T1", "me", rig.trial->now()).success);
  rig.commandByOther(0, {"PTP(\"JPP\",0,45,60,-15,90,0,5,200,0,false)"});
  rig.pass(5s);
  const auto recovered = rig.supervision().recover("RA", "T1", "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.looks_at_zones = true;
  rig.pass(1s);
  rig.order(0, 1, {"BACK"});
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotThatIsMovedOffItsPathInAZone, isToldOfAndStoppedAndKeepsTheZone) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.looks_at_zones = false;
  // Behind what is under way, of which nobody knows.
  rig.commandByOther(0, {"PTP(\"JPP\",60,45,60,-15,90,0,5,200,0,false)"});
  ASSERT_TRUE(rig.passUntil([&] { return turned(rig, 0) > 0.1; }, 20s));
  const Instant left = rig.trial->now();
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(0).state == RobotState::OffPath; }, 1s));
  EXPECT_LE(rig.trial->now() - left, kTwoFrames);
  rig.pass(20s);
  EXPECT_LT(turned(rig, 0), 5) << "it was stopped";
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kOffPath);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_FALSE(rig.isIn(1, 0));
}

TEST(ARobotThatWasStoppedAndIsMovedByHand, isToldOfWhereItGoes) {
  RunRig rig(artifactOf("handover"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).cancel(rig.robot(0).lastGoal());
  rig.pass(1s);
  ASSERT_EQ(rig.of(0).state, RobotState::Fault);
  rig.looks_at_zones = false;
  rig.commandByOther(0, {"PTP(\"JPP\",10,45,60,-15,90,0,5,200,0,false)"});
  ASSERT_TRUE(rig.passUntil([&] { return turned(rig, 0) > 1; }, 5s));
  rig.pass(100ms);
  EXPECT_EQ(rig.of(0).state, RobotState::OffPath);
}

TEST(ARobotThatIsMovedIntoAZoneOfAnother, stopsBothAndHoldsTheCell) {
  RunRig rig(artifactOf("handover"));
  bringIntoTheZone(rig);
  rig.robot(1).cancel(rig.robot(1).lastGoal());
  rig.pass(100ms);
  rig.looks_at_zones = false;
  rig.robot(1).operate(simulator::SetOperatingMode{simulator::OperatingMode::Manual});
  rig.commandByOther(1, {"PTP(\"JPP\",0,45,60,-15,90,0,2,200,0,false)"});
  ASSERT_TRUE(rig.passUntil([&] { return rig.isIn(1, 0); }, 60s));
  EXPECT_TRUE(rig.passUntil([&] { return rig.mode() == SupervisorMode::Holding; }, 100ms));
  EXPECT_THAT(rig.trial->status().diagnosis, HasSubstr("INTRUSION: RB is in Z1, which RA holds"));
  rig.pass(1s);
  EXPECT_FALSE(rig.isMoving(0) || rig.isMoving(1));
  EXPECT_EQ(rig.zone(0).state, cell::ZoneState::Quarantined);
}

TEST(ACellThatIsFinished, endsGoalsWithoutAnEndOfTheirOwnAsDoneAtHome) {
  RunRig rig(artifactOf("handover"));
  rig.begin(0);
  ASSERT_TRUE(rig.goesInto(0, 0));
  EXPECT_TRUE(rig.supervision().finish(true, rig.trial->now()).success);
  EXPECT_TRUE(rig.endsAll());
  EXPECT_EQ(rig.placeOf(0), "HOME");
  EXPECT_EQ(rig.placeOf(1), "HOME");
  rig.order(0, 1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 2s));
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kNotPermitted) << "it would begin another cycle";
  EXPECT_TRUE(rig.supervision().finish(false, rig.trial->now()).success);
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.ends(0));
}

TEST(APause, isNoWaitingHoweverLongItTakes) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(1);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).operate(simulator::PauseProject{});
  rig.pass(50s);  // RB gives up behind a minute
  rig.robot(0).operate(simulator::ResumeProject{});
  rig.pass(5s);
  rig.robot(0).operate(simulator::PauseProject{});
  rig.pass(70s);
  EXPECT_FALSE(rig.robot(0).hasEnded());
  rig.robot(0).operate(simulator::ResumeProject{});
  EXPECT_TRUE(rig.ends(0));
}

}  // namespace
}  // namespace cobot_command::trial
