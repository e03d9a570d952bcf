// Tools, frames and loads of the core: written and told, or refused.

#include "core_rig.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::testing {
namespace {

using namespace command;
using ::testing::HasSubstr;

tables::Tool toolAt(double x) {
  return {"", arm::toPose({x, 0, 0, 0, 0, 0}), 0};
}
tables::Load weighing(double mass) {
  tables::Load load;
  load.mass = mass;
  return load;
}
TableWrite tool(int index, std::optional<tables::Tool> tool) {
  return {index, std::move(tool)};
}
TableWrite load(int index, double mass) {
  return {index, std::optional(weighing(mass))};
}

class TableWriteTest : public ::testing::Test {
 protected:
  TableWriteTest() : rig(*arm::ArmModel::named("tm5-900")) {}
  TableAnswer write(const TableWrite& what) {
    TableAnswer answer = rig.core.writeTable(what);
    rig.pump();
    return answer;
  }
  CoreRig rig;
};

TEST_F(TableWriteTest, tellsAndAnswersTheTablesAsTheyAreThen) {
  const auto written = write(tool(3, toolAt(150)));
  ASSERT_TRUE(written);
  EXPECT_TRUE(written->changed);
  EXPECT_EQ(written->tables.entries().tools[3], toolAt(150));
  ASSERT_EQ(rig.told_tables.size(), 1U);
  EXPECT_EQ(rig.told_tables[0].entries().tools[3], toolAt(150));
}

TEST_F(TableWriteTest, takesFramesAndLoadsAndEmptiesEntries) {
  EXPECT_TRUE(write({2, std::optional(tables::Frame{"table", std::nullopt, 0})}));
  EXPECT_TRUE(write(load(1, 2)));
  EXPECT_TRUE(write({2, std::optional<tables::Frame>()}));
  EXPECT_FALSE(rig.told_tables.back().entries().frames[2]);
  EXPECT_EQ(rig.told_tables.back().load(1)->mass, 2);
}

TEST_F(TableWriteTest, tellsNothingOfWhatIsThereAlready) {
  EXPECT_TRUE(write(tool(3, toolAt(150))));
  const auto again = write(tool(3, toolAt(150)));
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->changed);
  EXPECT_EQ(rig.told_tables.size(), 1U);
}

TEST_F(TableWriteTest, refusesWhatTheTablesDoNotTake) {
  EXPECT_EQ(write(tool(0, toolAt(1))).error().error_id, tables::table_error::kToolIndex);
  EXPECT_EQ(write(tool(16, toolAt(1))).error().error_id, tables::table_error::kToolIndex);
  EXPECT_EQ(write(load(-1, 1)).error().error_id, tables::table_error::kLoadIndex);
  EXPECT_TRUE(rig.told_tables.empty());
}

TEST_F(TableWriteTest, knowsWhatTheArmCarries) {
  const auto refused = write(load(1, 5));
  EXPECT_EQ(refused.error().error_id, tables::table_error::kMass);
  EXPECT_THAT(describe(refused.error()), HasSubstr("0 to 4 kg, the payload of tm5-900"));
  EXPECT_TRUE(write(load(1, 4)));
}

TEST_F(TableWriteTest, saysBeforehandWhatItWouldAnswerAndChangesNothing) {
  EXPECT_TRUE(write(tool(3, toolAt(150))));
  const auto tried = rig.core.tryTable(tool(3, toolAt(1)));
  ASSERT_TRUE(tried);
  EXPECT_TRUE(tried->changed);
  EXPECT_EQ(tried->tables.entries().tools[3], toolAt(1));
  EXPECT_EQ(rig.core.tryTable(load(1, 5)).error().error_id, tables::table_error::kMass);
  rig.pump();
  EXPECT_EQ(rig.told_tables.size(), 1U);
  EXPECT_FALSE(write(tool(3, toolAt(150)))->changed) << "it is as it was";
}

TEST_F(TableWriteTest, beginsWithTheTablesThatWereKept) {
  tables::Entries entries;
  entries.tools[3] = toolAt(150);
  rig.core.useTables(*tables::DataTables::of(entries, {}));
  rig.pump();
  ASSERT_EQ(rig.told_tables.size(), 1U);
  EXPECT_FALSE(write(tool(3, toolAt(150)))->changed);
}

TEST(TableWriteWithoutAModel, takesWhatTheStrongestArmCarries) {
  CoreRig rig;
  EXPECT_TRUE(rig.core.writeTable(load(1, 14)));
  EXPECT_EQ(rig.core.writeTable(load(1, 14.1)).error().error_id, tables::table_error::kMass);
}

}  // namespace
}  // namespace cobot_command::testing
