#include "cobot_command/tables/table_store.h"

#include "table_support.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace tables;

/// Tool 1 with load 2, frame 4 in frame 3; tool 5, frame 6 and load 7 stand alone.
struct TableStoreTest : ::testing::Test {
  TableStoreTest() : store(someTables(), kPayload) {}

  static DataTables someTables() {
    Entries entries;
    entries.loads[2] = weighing(1);
    entries.loads[7] = weighing(2);
    entries.tools[1] = toolAt(1, 2);
    entries.tools[5] = toolAt(5);
    entries.frames[3] = frameAt(3);
    entries.frames[4] = frameAt(4, 3);
    entries.frames[6] = frameAt(6);
    return *DataTables::of(entries, kPayload);
  }
  int tool(int index) { return idOf(store.writeTool(index, toolAt(100))); }
  int frame(int index) { return idOf(store.writeFrame(index, frameAt(100))); }
  int load(int index) { return idOf(store.writeLoad(index, weighing(3))); }

  TableStore store;
};

TEST_F(TableStoreTest, writesWhatNobodyUses) {
  EXPECT_EQ(tool(1), 0);
  EXPECT_EQ(frame(4), 0);
  EXPECT_EQ(load(2), 0);
  EXPECT_NEAR(store.tables().toolInFlange(1)->translation().x(), 0.1, 1e-12);
  EXPECT_EQ(store.tables().load(2)->mass, 3);
}

TEST_F(TableStoreTest, refusesAToolInUseAndItsLoad) {
  const Hold path = store.hold({"load_path 7", {1}, {}});
  EXPECT_EQ(tool(1), table_error::kToolInUse);
  EXPECT_EQ(load(2), table_error::kLoadInUse);
  EXPECT_EQ(tool(5), 0);
  EXPECT_EQ(load(7), 0);
  EXPECT_EQ(frame(4), 0);
}

TEST_F(TableStoreTest, refusesAFrameInUseAndItsReference) {
  const Hold path = store.hold({"load_path 7", {}, {4}});
  EXPECT_EQ(frame(4), table_error::kFrameInUse);
  EXPECT_EQ(frame(3), table_error::kFrameInUse);
  EXPECT_EQ(frame(6), 0);
  EXPECT_EQ(tool(1), 0);
}

TEST_F(TableStoreTest, refusesToEmptyWhatIsInUse) {
  const Hold path = store.hold({"load_path 7", {5}, {6}});
  EXPECT_EQ(idOf(store.writeTool(5, std::nullopt)), table_error::kToolInUse);
  EXPECT_EQ(idOf(store.writeFrame(6, std::nullopt)), table_error::kFrameInUse);
}

TEST_F(TableStoreTest, saysWhoUsesAnEntry) {
  const Hold path = store.hold({"load_path 7", {1}, {}});
  EXPECT_EQ(describe(*store.writeTool(1, toolAt(2))),
            "tool 1: load_path 7 uses it; allowed: to write an entry that is not in use. Wait until it is "
            "done, or cancel it");
}

TEST_F(TableStoreTest, countsUsesUntilTheLastIsOver) {
  Hold first = store.hold({"first", {1}, {}});
  Hold second = store.hold({"second", {1}, {}});
  Hold copy = second;
  first.reset();
  EXPECT_EQ(store.userOf(Kind::Tool, 1), "second");
  second.reset();
  EXPECT_EQ(tool(1), table_error::kToolInUse) << "a copy holds as well";
  copy.reset();
  EXPECT_EQ(tool(1), 0);
}

TEST_F(TableStoreTest, hasNoUserOfNumberZeroWhichIsFixed) {
  const Hold path = store.hold({"load_path 7", {0, 5}, {0, 6}});
  EXPECT_EQ(store.userOf(Kind::Tool, 0), std::nullopt);
  EXPECT_EQ(store.userOf(Kind::Frame, 0), std::nullopt);
  EXPECT_EQ(store.userOf(Kind::Load, 0), std::nullopt);
  EXPECT_EQ(tool(0), table_error::kToolIndex);
}

TEST_F(TableStoreTest, holdsNumbersThatAreNotThereWithoutHarm) {
  const Hold path = store.hold({"load_path 7", {-1, 16, 9}, {-1, 16, 9}});
  EXPECT_EQ(tool(5), 0);
  EXPECT_EQ(tool(9), table_error::kToolInUse);
}

TEST_F(TableStoreTest, saysWhatIsWrongWithAnEntryBeforeItSaysWhoUsesIt) {
  const Hold path = store.hold({"load_path 7", {1}, {}});
  EXPECT_EQ(idOf(store.writeLoad(2, weighing(5))), table_error::kMass);
}

TEST_F(TableStoreTest, triesWithoutAChange) {
  const auto changed = store.withTool(1, toolAt(100));
  EXPECT_NEAR(changed->toolInFlange(1)->translation().x(), 0.1, 1e-12);
  EXPECT_NEAR(store.tables().toolInFlange(1)->translation().x(), 0.001, 1e-12);
}

TEST_F(TableStoreTest, leavesAPlanTheTablesThatItWasGiven) {
  const DataTables planned = store.tables();
  EXPECT_EQ(tool(1), 0);
  EXPECT_NEAR(planned.toolInFlange(1)->translation().x(), 0.001, 1e-12);
}

}  // namespace
}  // namespace cobot_command::testing
