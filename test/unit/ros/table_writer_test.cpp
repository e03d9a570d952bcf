// Entries that are kept first, and rule then. Threads, but no waiting: what hangs is released by the test.

#include "tables/table_writer.h"

#include <chrono>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "cobot_command/tables/table_store.h"

namespace cobot_command::ros_adapter {
namespace {

using command::TableAnswer;
using command::TableWrite;
using command::TableWritten;
using tables::DataTables;
using ::testing::HasSubstr;

using namespace std::chrono_literals;

constexpr auto kDeadline = std::chrono::seconds(30);

TableWrite tool(int index, const std::string& name) {
  return {index, std::optional(tables::Tool{name, std::nullopt, 0})};
}

/// A core and a disk, both of which can refuse.
struct TableWriterTest : ::testing::Test {
  using Asked = std::optional<std::future<TableAnswer>>;

  static Asked answered(TableAnswer answer) {
    std::promise<TableAnswer> promise;
    promise.set_value(std::move(answer));
    return promise.get_future();
  }
  Asked tried(const TableWrite& write) {
    if (is_closed) return std::nullopt;
    auto with = store.withTool(write.index, std::get<std::optional<tables::Tool>>(write.entry));
    if (!with) return answered(refuse(with.error()));
    return answered(TableWritten{*with, is_new});
  }
  Asked written(const TableWrite& write) {
    auto answer = tried(write);
    if (hold_before_written) hold = store.hold({"a path", {write.index}, {}});
    answer = tried(write);
    auto taken = answer->get();
    if (taken) store.replace(taken->tables);
    return answered(taken);
  }
  std::optional<std::string> keep(const DataTables& tables) {
    if (hangs.valid()) hangs.wait();
    if (disk_fault) return disk_fault;
    kept.push_back(tables);
    return std::nullopt;
  }
  TableAnswer write(const TableWrite& what) {
    auto answer = writer.write(what);
    if (answer.wait_for(kDeadline) != std::future_status::ready) ADD_FAILURE() << "no answer";
    return answer.get();
  }

  tables::TableStore store;
  tables::Hold hold;
  std::optional<std::string> disk_fault;
  std::vector<DataTables> kept;
  std::shared_future<void> hangs;  ///< valid: until then the disk does not answer
  bool is_new = true;
  bool is_closed = false;
  bool hold_before_written = false;
  TableWriter writer{
      {},
      {[this](const TableWrite& w) { return tried(w); }, [this](const TableWrite& w) { return written(w); }},
      [this](const DataTables& t) { return keep(t); }};
};

TEST_F(TableWriterTest, keepsWhatIsWrittenBeforeItRules) {
  const auto answer = write(tool(3, "gripper"));
  ASSERT_TRUE(answer);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_TRUE(kept[0].entries().tools[3]);
  EXPECT_TRUE(store.tables().entries().tools[3]);
}

TEST_F(TableWriterTest, keepsNothingThatIsRefusedOrNotNew) {
  EXPECT_EQ(write(tool(0, "gripper")).error().error_id, tables::table_error::kToolIndex);
  is_new = false;
  EXPECT_FALSE(write(tool(3, "gripper"))->changed);
  EXPECT_TRUE(kept.empty());
}

TEST_F(TableWriterTest, changesNothingThatCannotBeKept) {
  disk_fault = "/data/tables.new cannot be written: No space left on device";
  const auto answer = write(tool(3, "gripper"));
  EXPECT_EQ(answer.error().error_id, tables::table_error::kNotKept);
  EXPECT_THAT(describe(answer.error()),
              HasSubstr("tool 3: it cannot be stored: /data/tables.new cannot be written"));
  EXPECT_FALSE(store.tables().entries().tools[3]);
}

TEST_F(TableWriterTest, putsTheFileBackWhenSomebodyHasBegunToUseTheEntry) {
  ASSERT_TRUE(write(tool(1, "first")));
  hold_before_written = true;
  EXPECT_EQ(write(tool(3, "gripper")).error().error_id, tables::table_error::kToolInUse);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_TRUE(kept[2].entries().tools[1]);
  EXPECT_FALSE(kept[2].entries().tools[3]);
}

TEST_F(TableWriterTest, refusesWhenTheCoreIsClosed) {
  is_closed = true;
  EXPECT_EQ(write(tool(3, "gripper")).error().error_id, tables::table_error::kShutDown);
}

TEST(TableWriter, leavesADiskThatHangsBehindAndAsksTheCoreNoMore) {
  std::promise<void> release;
  std::promise<void> begun;
  const auto hangs = release.get_future().share();
  std::future<TableAnswer> first;
  std::future<TableAnswer> second;
  bool is_gone = false;
  {
    const auto tried = [](const TableWrite&) {
      std::promise<TableAnswer> promise;
      promise.set_value(TableWritten{{}, true});
      return std::optional(promise.get_future());
    };
    TableWriter writer({},
                       {[tried](const TableWrite& write) { return tried(write); },
                        [tried, &is_gone](const TableWrite& write) {
                          EXPECT_FALSE(is_gone);
                          return tried(write);
                        }},
                       [hangs, &begun](const DataTables&) {
                         if (hangs.wait_for(0s) == std::future_status::ready) return std::nullopt;  // back
                         begun.set_value();
                         hangs.wait();
                         return std::nullopt;
                       });
    first = writer.write(tool(1, "a"));
    ASSERT_EQ(begun.get_future().wait_for(kDeadline), std::future_status::ready);
    second = writer.write(tool(2, "b"));
  }
  is_gone = true;
  EXPECT_EQ(second.get().error().error_id, tables::table_error::kShutDown);
  release.set_value();
  EXPECT_EQ(first.get().error().error_id, tables::table_error::kShutDown);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
