// Who wins where our tables and the controller's project differ.
#include "sync/sync_policy.h"

#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::command {
namespace {

using tables::Kind;

class SyncPolicyTest : public ::testing::Test {
 protected:
  void begin(SyncMode start, SyncMode run) {
    ExchangeRules rules;
    const SyncModes modes{static_cast<int>(start), static_cast<int>(run)};
    rules.sync = {modes, modes, modes};
    policy.begin(rules);
  }
  void tool(int index, const std::string& name, double z, int load = 0) {
    EXPECT_FALSE(ours.writeTool(index, tables::Tool{name, at(0, z), load}, {}));
  }
  void frame(int index, const std::string& name, double x, int reference = 0) {
    EXPECT_FALSE(ours.writeFrame(index, tables::Frame{name, at(x, 0), reference}, {}));
  }
  void load(int index, double mass) {
    tables::Load load;
    load.mass = mass;
    EXPECT_FALSE(ours.writeLoad(index, load, {}));
  }
  static arm::Pose at(double x, double z) { return arm::toPose({x, 0, z, 0, 0, 0}); }
  SyncLook look(bool is_used = false) {
    return policy.look(ours, theirs, [is_used](Kind, int) { return is_used; });
  }
  /// As our tables are to be.
  void take(const SyncLook& look) {
    for (const TableWrite& write : look.for_tables) {
      if (const auto* const frame = std::get_if<std::optional<tables::Frame>>(&write.entry)) {
        EXPECT_FALSE(ours.writeFrame(write.index, *frame, {}));
      }
    }
  }
  double frameX(int index) { return mToMm(ours.frameInRobotBase(index)->translation().x()); }

  SyncPolicy policy;
  tables::DataTables ours;
  ProjectValues theirs;
};

TEST_F(SyncPolicyTest, takesAFrameBehindTheOneThatItRefersTo) {
  begin(SyncMode::ServerToClient, SyncMode::ClientToServer);
  frame(1, "cell", 100);
  frame(2, "table", 50, 1);
  theirs.bases = {{"cell", at(110, 0)}, {"table", at(150, 0)}};
  const SyncLook first = look();
  take(first);
  EXPECT_NEAR(frameX(1), 110, 1e-9);
  EXPECT_NEAR(frameX(2), 150, 1e-9) << "where the controller has it";
  EXPECT_TRUE(look().for_project.empty()) << "nothing wrong is written back";
}

TEST_F(SyncPolicyTest, doesNotTakeAFrameForChangedWhoseReferenceWasTaken) {
  begin(SyncMode::None, SyncMode::Automatic);
  frame(1, "cell", 100);
  frame(2, "table", 50, 1);
  theirs.bases = {{"cell", at(100, 0)}, {"table", at(150, 0)}};
  EXPECT_TRUE(look().isInSync(Kind::Frame));
  theirs.bases["cell"] = at(110, 0);
  const SyncLook changed = look();
  take(changed);
  EXPECT_NEAR(frameX(1), 110, 1e-9);
  EXPECT_TRUE(changed.for_project.empty());
}

TEST_F(SyncPolicyTest, letsTheStartWaitUntilAnEntryIsFree) {
  begin(SyncMode::ServerToClient, SyncMode::None);
  tool(3, "gripper", 150);
  theirs.tcps = {{"gripper", at(0, 160)}};
  EXPECT_TRUE(look(true).for_tables.empty());
  EXPECT_EQ(look().for_tables.size(), 1U);
}

TEST_F(SyncPolicyTest, writesNothingWhereTwoEntriesGiveOneNameDifferentValues) {
  begin(SyncMode::ClientToServer, SyncMode::ClientToServer);
  tool(3, "gripper", 150);
  tool(4, "gripper", 170);
  theirs.tcps = {{"gripper", at(0, 150)}};
  const SyncLook shown = look();
  EXPECT_TRUE(shown.for_project.empty());
  ASSERT_EQ(shown.differences.size(), 2U);
  EXPECT_NE(shown.differences.at({Kind::Tool, 3}).find("tool 4"), std::string::npos);
}

TEST_F(SyncPolicyTest, comparesTheCentreOfALoadInItsToolWhereverThatIs) {
  begin(SyncMode::ClientToServer, SyncMode::ClientToServer);
  load(1, 2);
  tool(3, "gripper", 150, 1);
  theirs.tcps = {{"gripper", at(0, 160)}};
  theirs.burdens["gripper"].mass = 2;
  theirs.burdens["gripper"].centre = at(0, -150);
  const SyncLook shown = look();
  EXPECT_EQ(shown.differences.count({Kind::Tool, 3}), 1U);
  EXPECT_TRUE(shown.isInSync(Kind::Load)) << shown.differences.at({Kind::Load, 1});
  EXPECT_EQ(shown.for_project.size(), 1U);
}

TEST_F(SyncPolicyTest, knowsWhatWasWrittenForNobodyElsesChange) {
  begin(SyncMode::ClientToServer, SyncMode::ClientToServer);
  tool(3, "gripper", 150);
  theirs.tcps = {{"gripper", at(0, 160)}};
  EXPECT_EQ(look().for_project.size(), 1U);
  policy.written();
  theirs.tcps = {{"gripper", at(0, 150)}};
  const SyncLook then = look();
  EXPECT_EQ(then.changed.tools, 0);
  EXPECT_TRUE(then.isInSync(Kind::Tool));
}

}  // namespace
}  // namespace cobot_command::command
