// Stops, errors and pauses of one robot: the zones stay, and the rest of the cell goes on.
#include "run_rig.h"

namespace cobot_command::trial {
namespace {

using cell::RobotState;
using cell::WaitReason;
using cell::ZoneState;

/// R1 of the iris fails in the first of its zones. Who needs that one waits, the third robot goes on, and
/// behind the recovery all come to an end.
void expectRecovery(const std::vector<simulator::OperatorAction>& trouble,
                    const std::vector<simulator::OperatorAction>& relief, const std::string& why) {
  RunRig rig(artifactOf("iris"));
  ASSERT_TRUE(rig.trial->start());
  rig.order(0, 2);
  std::optional<cell::ZoneIndex> held;
  ASSERT_TRUE(rig.passUntil([&] {
    for (const cell::ZoneIndex zone : rig.artifact->program.robots[0].paths[0].steps[0].zones) held = zone;
    return rig.isMoving(0) && rig.isIn(0, *held) && rig.zone(*held).owner == "R1";
  }));
  for (const auto& action : trouble) rig.robot(0).operate(action);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).hasEnded(); }, 30s));
  EXPECT_EQ(rig.robot(0).lastOutcome()->ending, blocks::Ending::Aborted);
  EXPECT_THAT(rig.robot(0).lastOutcome()->error_description, ::testing::HasSubstr(why));
  rig.pass(1s);
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  EXPECT_EQ(rig.zone(*held).owner, "R1");
  EXPECT_EQ(rig.zone(*held).state, ZoneState::Quarantined);
  const cell::RobotIndex blocked = rig.artifact->zones[*held].users.back();
  const cell::RobotIndex free = 3 - blocked;
  rig.order(free, 1);
  EXPECT_TRUE(rig.ends(free, 60s));
  rig.order(blocked, 1);
  rig.pass(20s);
  EXPECT_EQ(rig.of(blocked).reason, WaitReason::Quarantined);
  EXPECT_FALSE(rig.isMoving(blocked));

  for (const auto& action : relief) rig.robot(0).operate(action);
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).isReady(); }, 30s));
  rig.pass(1s);
  const auto recovered = rig.supervision().recover("R1", rig.of(0).place, "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotInAnEmergencyStop, keepsItsZonesWhileTheOthersGoOn) {
  expectRecovery({simulator::SetEmergencyStop{true}},
                 {simulator::SetEmergencyStop{false}, simulator::RunProject{}}, "emergency stop");
}

TEST(ARobotWithAnError, keepsItsZonesWhileTheOthersGoOn) {
  expectRecovery({simulator::RaiseError{0x14058, "it is too much"}}, {simulator::ClearError{}}, "0x14058");
}

TEST(ARobotWithAnErrorWhileItStands, isRecoveredOnceThatIsOver) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  rig.robot(0).operate(simulator::RaiseError{0x14058, "it is too much"});
  rig.pass(1s);
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  const auto refused = rig.supervision().recover("RA", "HOME", "me", rig.trial->now());
  EXPECT_FALSE(refused.success);
  EXPECT_THAT(refused.message, ::testing::HasSubstr("end that at its pendant first"));
  rig.robot(0).operate(simulator::ClearError{});
  rig.pass(1s);
  const auto recovered = rig.supervision().recover("RA", "HOME", "me", rig.trial->now());
  ASSERT_TRUE(recovered.success) << recovered.message;
  rig.pass(1s);
  rig.trial->runAll(1);
  EXPECT_TRUE(rig.endsAll());
}

void expectOnlyTimeIsLost(const simulator::OperatorAction& trouble, const simulator::OperatorAction& relief) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).operate(trouble);
  rig.pass(20s);
  EXPECT_FALSE(rig.isMoving(0));
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_EQ(rig.zone(0).state, ZoneState::Held);
  EXPECT_EQ(rig.of(1).reason, WaitReason::ZoneHeld);
  EXPECT_FALSE(rig.robot(0).hasEnded());
  rig.robot(0).operate(relief);
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotThatIsPausedInAZone, losesNothingButTime) {
  expectOnlyTimeIsLost(simulator::PauseProject{}, simulator::ResumeProject{});
}

TEST(ARobotThatASafeguardHoldsInAZone, losesNothingButTime) {
  expectOnlyTimeIsLost(simulator::SetSafeguard{true}, simulator::SetSafeguard{false});
}

TEST(ARobotWhoseProjectIsSlowed, losesNothingButTime) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).operate(simulator::SetProjectSpeed{20});
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotInManualMode, keepsTheZoneThatItIsInAndGoesOnWhenThatEnds) {
  RunRig rig(artifactOf("handover"));
  rig.begin(2);
  ASSERT_TRUE(rig.goesInto(0, 0));
  rig.robot(0).operate(simulator::SetOperatingMode{simulator::OperatingMode::Manual});
  rig.pass(20s);
  EXPECT_EQ(rig.of(0).state, RobotState::Manual);
  EXPECT_EQ(rig.zone(0).owner, "RA");
  EXPECT_FALSE(rig.isIn(1, 0));
  rig.robot(0).operate(simulator::SetOperatingMode{simulator::OperatingMode::Automatic});
  EXPECT_TRUE(rig.endsAll());
}

TEST(ARobotWhoseProjectDoesNotRun, isNotReady) {
  RunRig rig(artifactOf("handover"));
  rig.robot(0).operate(simulator::StopProject{});
  EXPECT_FALSE(rig.trial->start());
  EXPECT_EQ(rig.mode(), cell::SupervisorMode::Starting);
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  EXPECT_THAT(rig.of(0).text, ::testing::HasSubstr("connection refused"));
  rig.robot(0).operate(simulator::RunProject{});
  EXPECT_TRUE(rig.passUntil([&] { return rig.mode() == cell::SupervisorMode::Ready; }, 30s));
}

TEST(ARobotWhoseProjectEndsWhileItStands, isGrantedNothingUntilItRunsAgain) {
  RunRig rig(artifactOf("handover"));
  ASSERT_TRUE(rig.trial->start());
  rig.robot(0).operate(simulator::StopProject{});
  rig.pass(1s);
  EXPECT_EQ(rig.of(0).state, RobotState::Fault);
  rig.order(1, 1);
  EXPECT_TRUE(rig.ends(1));
  rig.robot(0).operate(simulator::RunProject{});
  ASSERT_TRUE(rig.passUntil([&] { return rig.robot(0).isReady(); }, 30s));
  rig.pass(1s);
  EXPECT_EQ(rig.of(0).state, RobotState::Ready) << "by itself, as it stands at home";
  rig.order(0, 1);
  EXPECT_TRUE(rig.endsAll());
}

}  // namespace
}  // namespace cobot_command::trial
