// Who wins where our tables and the controller's project differ: SRCI oracle 15.
#include "synchronised_robot.h"

namespace cobot_command::testing {
namespace {

using blocks::RiState;
using command::SyncMode;

command::ExchangeRules rulesWith(SyncMode start, SyncMode run) {
  command::ExchangeRules rules;
  const command::SyncModes modes{static_cast<int>(start), static_cast<int>(run)};
  rules.sync = {modes, modes, modes};
  return rules;
}

/// SRCI oracle 15.
TEST(SyncModes, clientToServerWritesOursBack) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::ClientToServer));
  rig.enable();
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(2100ms);
  EXPECT_EQ(rig.countSent("TCP[\"gripper\"].Value="), 1);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_NEAR(rig.tool()[2], 150, 1e-9);
}

/// SRCI oracle 15.
TEST(SyncModes, serverToClientTakesTheirs) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::ServerToClient));
  rig.enable();
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(1100ms);
  EXPECT_NEAR(rig.tool()[2], 160, 1e-4);
  EXPECT_EQ(rig.countSent(".Value="), 0);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_EQ(rig.report().out_cmd.change_index_tool, kTool);
}

/// SRCI oracle 15.
TEST(SyncModes, automaticLetsNobodyWinWhereBothHaveChanged) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::Automatic));
  rig.enable();
  ASSERT_EQ(rig.riState(), RiState::Synchronized);
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.writeTool({0, 0, 170, 0, 0, 0});
  rig.pass(5s);
  EXPECT_EQ(rig.report().warning_id, 0x7013);
  EXPECT_EQ(rig.countMessages(0x7013), 1);
  EXPECT_NEAR(rig.tool()[2], 170, 1e-9);
  EXPECT_EQ(rig.countSent(".Value="), 0);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  rig.writeTool({0, 0, 180, 0, 0, 0});
  rig.pass(2100ms);
  EXPECT_EQ(rig.riState(), RiState::Synchronized) << "the next write decides";
  EXPECT_EQ(rig.report().warning_id, 0);
  EXPECT_NEAR(rig.tool()[2], 180, 1e-9);
}

TEST(SyncModes, automaticFollowsWhoHasChanged) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::Automatic));
  rig.enable();
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(1100ms);
  EXPECT_NEAR(rig.tool()[2], 160, 1e-4);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  rig.writeTool({0, 0, 130, 0, 0, 0});
  rig.pass(2100ms);
  EXPECT_EQ(rig.countSent("TCP[\"gripper\"].Value="), 1);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_EQ(rig.report().out_cmd.change_index_tool, kTool) << "of the pendant's change, not of ours";
}

TEST(SyncModes, ofTheStartRuleTheFirstLookAlone) {
  SynchronisedRobot rig(rulesWith(SyncMode::ServerToClient, SyncMode::None));
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.enable();
  rig.pass(100ms);
  EXPECT_NEAR(rig.tool()[2], 160, 1e-4);
  rig.setTcp({0, 0, 170, 0, 0, 0});
  rig.pass(2100ms);
  EXPECT_NEAR(rig.tool()[2], 160, 1e-4);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
}

TEST(SyncModes, automaticIsNoneAtTheStart) {
  SynchronisedRobot rig(rulesWith(SyncMode::Automatic, SyncMode::None));
  EXPECT_EQ(rig.errorOf(rig.enable()), 10);
}

TEST(SyncModes, bringLoadsAndFramesIntoLineToo) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::ClientToServer));
  rig.enable([](auto& s) {
    s.data_enable_sync = {true, true, true, false, false, false, false};
    s.data_in_sync = s.data_enable_sync;
  });
  ASSERT_EQ(rig.riState(), RiState::Synchronized);
  rig.setBase({1, 2, 3, 0, 0, 0});
  rig.operate(simulator::SetLoad{"gripper", 1, {}, {}});
  rig.pass(2100ms);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_EQ(rig.countSent("Base[\"table\"].Value="), 1);
  EXPECT_EQ(rig.countSent("TCP[\"gripper\"].Mass="), 1);
}

/// A path that uses the entry has it as it was planned.
TEST(SyncModes, changeNothingThatIsInUse) {
  SynchronisedRobot rig(rulesWith(SyncMode::None, SyncMode::ServerToClient));
  rig.enable();
  const auto path = rig.submit(withTheGripper(10));
  rig.pass(500ms);
  ASSERT_TRUE(rig.accepted(path));
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(2s);
  EXPECT_EQ(rig.outcome(path), nullptr);
  EXPECT_NEAR(rig.tool()[2], 150, 1e-9);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  EXPECT_EQ(rig.endOf(path).ending, blocks::Ending::Done);
  rig.pass(1100ms);
  EXPECT_NEAR(rig.tool()[2], 160, 1e-4) << "as soon as it is free";
}

}  // namespace
}  // namespace cobot_command::testing
