// A robot that nobody hears any more: what it may be in stays its own, and others keep out of it.
#include "run_rig.h"

namespace cobot_command::trial {
namespace {

using cell::RobotState;
using cell::WaitReason;
using cell::ZoneState;
using ::testing::HasSubstr;

/// Zones of R2 in the iris: with each of the others.
constexpr cell::ZoneIndex kOfR1 = 0;
constexpr cell::ZoneIndex kOfR3 = 2;

/// Of the iris, in degrees: on the way, and home.
constexpr const char* kOut = "PTP(\"JPP\",0,0,115,-85,90,0,30,200,0,false)";
constexpr const char* kHome = "PTP(\"JPP\",0,-60,140,10,90,0,30,200,0,false)";

TEST(ARobotThatIsSilentInAZone, keepsItAndGoesOnByItselfWhenItIsHeardAgain) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.trial->cut(0, true);
  ASSERT_TRUE(rig.passUntil([&] { return rig.of(0).state == RobotState::Lost; }, 600ms));
  EXPECT_EQ(rig.zone(0).state, ZoneState::Quarantined);
  rig.pass(20s);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_EQ(rig.of(1).reason, WaitReason::Quarantined);
  EXPECT_FALSE(rig.isMoving(1));

  rig.trial->cut(0, false);
  ASSERT_TRUE(rig.passUntil([&] { return rig.zone(0).state == ZoneState::Held; }, 1s));
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotThatIsSilentForAMomentAgainAndAgain, losesNothingButTime) {
  RunRig rig(artifactOf("head_on"));
  rig.begin(2);
  for (unsigned i = 0; i < 40; ++i) {
    const cell::RobotIndex robot = i % 2;
    rig.trial->cut(robot, true);
    rig.pass(std::chrono::milliseconds(550 + 170 * (i % 7)));
    rig.trial->cut(robot, false);
    rig.pass(std::chrono::milliseconds(130 * (i % 9)));
  }
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotThatIsKilledInTwoZones, keepsTheOthersBeforeThemUntilTheyAreConfirmedToBeClear) {
  RunRig rig(artifactOf("iris"));
  rig.begin(3);
  ASSERT_TRUE(rig.passUntil([&] {
    return rig.isMoving(1) && rig.isIn(1, kOfR1) && rig.isIn(1, kOfR3) && rig.zone(kOfR3).owner == "R2" &&
           rig.zone(kOfR1).owner == "R2";
  }));
  rig.trial->cut(1, true);
  rig.robot(1).dropConnections();
  rig.pass(30s);
  for (const cell::ZoneIndex zone : {kOfR1, kOfR3}) {
    EXPECT_EQ(rig.zone(zone).owner, "R2");
    EXPECT_EQ(rig.zone(zone).state, ZoneState::Quarantined);
  }
  for (const cell::RobotIndex other : {0U, 2U}) {
    EXPECT_FALSE(rig.isMoving(other));
    EXPECT_EQ(rig.of(other).reason, WaitReason::Quarantined) << other;
    EXPECT_THAT(rig.of(other).blocked_by, ::testing::Contains("R2"));
  }
  const auto refused = rig.supervision().confirmClear("R2", "me", false, rig.trial->now());
  EXPECT_FALSE(refused.success);
  EXPECT_THAT(refused.message, HasSubstr("R2 was in Z"));

  rig.looks_at_zones = false;
  rig.commandByOther(1, {kOut, kHome});
  ASSERT_TRUE(rig.passUntil([&] { return !rig.isMoving(1) && !rig.isIn(1, kOfR1) && !rig.isIn(1, kOfR3); }));
  rig.looks_at_zones = true;
  rig.dead = {1};
  EXPECT_TRUE(rig.supervision().confirmClear("R2", "me", true, rig.trial->now()).success);
  EXPECT_TRUE(rig.ends(0));
  EXPECT_TRUE(rig.ends(2));
  EXPECT_EQ(rig.of(1).state, RobotState::Out);
}

TEST(ARobotWhoseNodeIsStartedAnewInAZone, keepsItUntilAPersonHasRecoveredIt) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  cell::RobotReport late;
  late.robot = "RA";
  late.hash = rig.artifact->digest;
  late.session = rig.of(0).session;
  late.number = 1000000;
  rig.robot(0).restart(77);
  rig.pass(10s);
  EXPECT_EQ(rig.of(0).state, RobotState::Lost);
  EXPECT_THAT(rig.of(0).text, HasSubstr("its node was restarted"));
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_EQ(rig.zone(0).state, ZoneState::Quarantined);
  EXPECT_FALSE(rig.isIn(1, 0));

  const auto strange = rig.supervision().counts().wrong_sessions;
  rig.supervision().take(late, rig.trial->now());
  EXPECT_EQ(rig.supervision().counts().wrong_sessions, strange + 1);
  EXPECT_THAT(rig.of(0).text, HasSubstr("its node was restarted"));

  // Until then it goes nowhere.
  rig.order(0, 1);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 2s));
  EXPECT_EQ(rig.errorOf(0), blocks::own_error::kRecoveryNeeded);
  const std::string place = rig.of(0).place;
  EXPECT_FALSE(rig.supervision().recover("RA", "HOME", "me", rig.trial->now()).success);
  const auto recovered = rig.supervision().recover("RA", place, "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

TEST(ASecondNodeOfARobot, isNotListenedTo) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  cell::RobotReport second;
  second.robot = "RA";
  second.hash = rig.artifact->digest;
  second.session = 99;
  std::uint64_t told = 0;
  EXPECT_TRUE(rig.passUntil([&] {
    second.number = ++told;
    rig.supervision().take(second, rig.trial->now());
    return rig.robot(0).hasEnded() && rig.robot(1).hasEnded();
  }));
  EXPECT_TRUE(rig.endsAll(0s));
  EXPECT_EQ(rig.supervision().counts().wrong_sessions, told);
}

TEST(ARobotThatLosesTheLinkToItsController, hasToBeRecoveredAndKeepsItsZones) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).dropConnections();
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 30s));
  EXPECT_EQ(rig.errorOf(0), blocks::motion_error::kLinkDropped)
      << rig.robot(0).lastOutcome()->error_description;
  rig.pass(10s);
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_FALSE(rig.isIn(1, 0));
  const auto recovered = rig.supervision().recover("RA", rig.of(0).place, "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

}  // namespace
}  // namespace cobot_command::trial
