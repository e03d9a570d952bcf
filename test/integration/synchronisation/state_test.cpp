// Whether the data are in sync, and what is told of it: SRCI oracles 12 and 16.
#include "synchronised_robot.h"

namespace cobot_command::testing {
namespace {

using blocks::RiState;
using ::testing::HasSubstr;

/// SRCI oracle 12.
TEST(DataInSync, fallsWithAChangeOnThePendantAndComesBackWithIt) {
  SynchronisedRobot rig;
  rig.enable();
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_TRUE(rig.report().out_cmd.data_in_sync.tools);
  EXPECT_EQ(rig.report().out_cmd.change_index_tool, 0);
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(1100ms);
  EXPECT_FALSE(rig.report().out_cmd.data_in_sync.tools);
  EXPECT_EQ(rig.report().out_cmd.change_index_tool, kTool);
  EXPECT_EQ(rig.report().ri_state, RiState::Initialized);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  rig.setTcp({0, 0, 150, 0, 0, 0});
  rig.pass(1100ms);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
}

/// SRCI oracle 12: what floats and half turns leave is none.
TEST(DataInSync, isNotLostByWhatIsNoDifference) {
  SynchronisedRobot rig;
  rig.writeTool({0, 0, 150, 0, 0, 180});
  rig.setTcp({0, 0, 150.0005, 0, 0, -180});
  rig.enable();
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  rig.setTcp({0, 0, 150.002, 0, 0, -180});
  rig.pass(1100ms);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
}

/// SRCI oracle 16.
TEST(DataInSync, isNotHinderedByASetThatNoControllerHas) {
  SynchronisedRobot rig;
  rig.enable([](auto& s) { s.data_enable_sync.work_areas = true; });
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
}

/// SRCI oracle 16.
TEST(DataInSync, isNeverReachedWithoutASet) {
  SynchronisedRobot rig;
  rig.enable([](auto& s) { s.data_enable_sync.tools = false; });
  rig.pass(3s);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
}

/// SRCI oracle 16.
TEST(DataInSync, needsTheCallersOwnCopiesToo) {
  SynchronisedRobot rig;
  rig.enable([](auto& s) { s.data_in_sync.tools = false; });
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  EXPECT_TRUE(rig.report().out_cmd.data_in_sync.tools) << "the controller's half";
  EXPECT_THAT(rig.progress(rig.enable()).empty(), true) << "there is one already";
  ASSERT_TRUE(rig.change([](auto& s) { s.data_in_sync.tools = true; }).success);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
}

TEST(DataInSync, comparesFramesInTheRobotBase) {
  SynchronisedRobot rig;
  tables::Frame on_table;
  on_table.name = "table";
  on_table.pose = arm::toPose({300, 0, 0, 0, 0, 0});
  on_table.reference = 5;
  tables::Frame reference;
  reference.pose = arm::toPose({100, 100, 0, 0, 0, 0});
  ASSERT_TRUE(rig.write({5, std::optional(reference)}));
  ASSERT_TRUE(rig.write({kFrame, std::optional(on_table)}));
  rig.enable([](auto& s) { s.data_enable_sync.frames = s.data_in_sync.frames = true; });
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  rig.setBase({400, 101, 0, 0, 0, 0});
  rig.pass(1100ms);
  EXPECT_EQ(rig.report().out_cmd.change_index_frame, kFrame);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
}

TEST(DataInSync, comparesTheLoadOfANamedTool) {
  SynchronisedRobot rig;
  rig.enable([](auto& s) { s.data_enable_sync.loads = s.data_in_sync.loads = true; });
  EXPECT_EQ(rig.riState(), RiState::Synchronized) << rig.progress(2).back().text;
  rig.operate(simulator::SetLoad{"gripper", 2.5, {}, {}});
  rig.pass(1100ms);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  EXPECT_EQ(rig.report().out_cmd.change_index_load, 1);
}

TEST(DataInSync, isToldOfASetThatDiffersAndIsNotEnabledOnce) {
  SynchronisedRobot rig;
  rig.setBase({400, 101, 0, 0, 0, 0});
  rig.enable();
  rig.pass(5s);
  EXPECT_EQ(rig.riState(), RiState::Synchronized);
  EXPECT_EQ(rig.report().info_id, 0x6020);
  EXPECT_EQ(rig.countMessages(0x6020), 1);
}

TEST(DataInSync, isFalseForANameThatTheProjectDoesNotHaveAndSaidOnce) {
  SynchronisedRobot rig;
  rig.writeTool({0, 0, 150, 0, 0, 0}, "lost");
  rig.enable([](auto& s) { s.data_enable_sync.frames = s.data_in_sync.frames = true; });
  rig.pass(5s);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  EXPECT_FALSE(rig.report().out_cmd.data_in_sync.tools);
  EXPECT_TRUE(rig.report().out_cmd.data_in_sync.frames) << "the others are read all the same";
  EXPECT_EQ(rig.report().warning_id, 0x7044);
  EXPECT_EQ(rig.countMessages(0x7044), 1);
  EXPECT_EQ(rig.countSent("lost"), 1) << "it is not asked for with each look";
}

TEST(DataInSync, isFalseWhereTheControllerTellsNoValues) {
  SynchronisedRobot rig({}, "1.72");
  rig.enable();
  rig.pass(5s);
  EXPECT_EQ(rig.riState(), RiState::Initialized);
  EXPECT_EQ(rig.report().warning_id, 0x7044);
  EXPECT_EQ(rig.countSent("ListenSend"), 3) << "one refusal alone says little";
  rig.pass(20s);
  EXPECT_EQ(rig.countSent("ListenSend"), 5) << "now and then, as another TMflow may have been started";
  EXPECT_EQ(rig.countMessages(0x7044), 1);
}

TEST(DataInSync, isLookedAtWithEachPeriodAndNotWithoutANamedEntry) {
  command::ExchangeRules rules;
  rules.sync_period = 2s;
  SynchronisedRobot rig(rules);
  rig.enable();
  rig.pass(10s);
  EXPECT_EQ(rig.countSent("ListenSend"), 6);
  CoreAndRobot bare;
  bare.connect();
  auto goal = good<blocks::ExchangeConfigurationGoal>();
  goal.settings.data_enable_sync.tools = goal.settings.data_in_sync.tools = true;
  bare.submit(goal);
  bare.pass(5s);
  EXPECT_TRUE(bare.scripts().empty());
  EXPECT_EQ(bare.group().ri_state, RiState::Synchronized);
}

TEST(DataInSync, isMissedByPlansThatSayWithWhichValueTheyAreMade) {
  SynchronisedRobot rig;
  rig.enable();
  rig.setTcp({0, 0, 160, 0, 0, 0});
  rig.pass(1100ms);
  auto path = withTheGripper(100);
  path.check_only = true;
  EXPECT_EQ(rig.endOf(rig.submit(path)).error_id, 0);
  ASSERT_FALSE(rig.warnings().empty());
  EXPECT_THAT(rig.warnings().back(), HasSubstr("planned with the values of this node: tool 3"));
}

TEST(DataInSync, lendsPlansTheValuesThatOnlyTheProjectKnows) {
  SynchronisedRobot rig;
  tables::Tool project_tool;
  project_tool.name = "gripper";
  ASSERT_TRUE(rig.write({kTool, std::optional(project_tool)}));
  auto path = withTheGripper(100);
  path.check_only = true;
  EXPECT_EQ(rig.endOf(rig.submit(path)).error_id, 1041);
  rig.enable();
  EXPECT_EQ(rig.riState(), RiState::Synchronized) << "there is nothing of ours that it could differ from";
  EXPECT_EQ(rig.endOf(rig.submit(path)).error_id, 0) << rig.endOf(rig.submit(path)).error_description;
}

}  // namespace
}  // namespace cobot_command::testing
