// Entries of the tables as messages, and what is told of their changes.

#include "tables/table_messages.h"

#include <limits>

#include "tables/table_board.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using tables::Kind;
using tables::table_error::kCoordinateRange;
using tables::table_error::kNotFinite;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

arm::Pose pose() {
  return arm::toPose({1, 2, 3, 10, 20, 30});
}
/// That is no pose.
cobot_command::Transformation wrong(double z) {
  cobot_command::Transformation six;
  six.z = z;
  return six;
}

template <class Entry>
Entry entryOf(const command::TableWrite& write) {
  return *std::get<std::optional<Entry>>(write.entry);
}

TEST(TableMessages, sayToolsInMillimetresAndDegreesAndTakeThemBack) {
  const tables::Tool tool{"gripper", pose(), 2};
  const auto message = toMessage(3, tool);
  EXPECT_EQ(message.index, 3);
  EXPECT_FALSE(message.empty || message.name_only);
  EXPECT_EQ(message.name, "gripper");
  EXPECT_EQ(toSix(message.tcp), (arm::ControllerPose{1, 2, 3, 10, 20, 30})) << "to the last digit";
  EXPECT_EQ(message.load, 2);
  const auto write = toWrite(message);
  EXPECT_EQ(write->index, 3);
  EXPECT_EQ(entryOf<tables::Tool>(*write), tool);
}

TEST(TableMessages, sayFramesAndTakeThemBack) {
  const tables::Frame frame{"", pose(), 5};
  const auto message = toMessage(4, frame);
  EXPECT_EQ(message.reference, 5);
  EXPECT_EQ(entryOf<tables::Frame>(*toWrite(message)), frame);
}

TEST(TableMessages, sayLoadsInKgMm2AndTakeThemBack) {
  const tables::Load load{2.5, {2e-3, 1e-3, 5e-4}, pose()};
  const auto message = toMessage(1, load);
  EXPECT_EQ(message.mass, 2.5);
  EXPECT_EQ(message.moment_of_inertia.ixx, 2000);
  EXPECT_EQ(message.moment_of_inertia.iyy, 1000);
  EXPECT_EQ(message.moment_of_inertia.izz, 500);
  const auto back = entryOf<tables::Load>(*toWrite(message));
  EXPECT_EQ(back.mass, load.mass);
  EXPECT_NEAR(back.inertia[2], load.inertia[2], 1e-18);
  EXPECT_TRUE(back.centre.isApprox(load.centre, 1e-12));
}

TEST(TableMessages, sayWhatOnlyTheProjectKnowsAndWhatIsEmpty) {
  const tables::Tool named{"gripper", std::nullopt, 0};
  EXPECT_TRUE(toMessage(3, named).name_only);
  EXPECT_EQ(entryOf<tables::Tool>(*toWrite(toMessage(3, named))), named);
  const auto empty = toMessage(3, std::optional<tables::Tool>());
  EXPECT_TRUE(empty.empty);
  EXPECT_EQ(std::get<std::optional<tables::Tool>>(toWrite(empty)->entry), std::nullopt);
  EXPECT_EQ(
      std::get<std::optional<tables::Load>>(toWrite(toMessage(1, std::optional<tables::Load>()))->entry),
      std::nullopt);
}

TEST(TableMessages, refusePosesThatAreNone) {
  cobot_command::ToolData tool;
  cobot_command::FrameData frame;
  cobot_command::LoadData load;
  tool.index = frame.index = load.index = 1;
  for (const auto& [z, id] : {std::pair(kNan, kNotFinite), {1e6, kCoordinateRange}}) {
    tool.tcp = frame.pose = load.mass_center = wrong(z);
    EXPECT_EQ(toWrite(tool).error().error_id, id);
    EXPECT_EQ(toWrite(frame).error().error_id, id);
    EXPECT_EQ(toWrite(load).error().error_id, id);
  }
  tool.name_only = true;
  EXPECT_TRUE(toWrite(tool)) << "it is not looked at";
}

TEST(TableMessages, leaveAWrongNumberToTheTablesWhateverElseIsWrong) {
  cobot_command::ToolData tool;
  tool.tcp = wrong(kNan);
  for (const int index : {-1, 0, 16}) {
    tool.index = index;
    EXPECT_EQ(toWrite(tool)->index, index);
  }
}

TEST(TableMessages, listWhatIsConfiguredButNumberZero) {
  tables::Entries entries;
  entries.tools[3] = tables::Tool{"gripper", std::nullopt, 0};
  entries.loads[15] = tables::Load{};
  const auto message = toMessage(*tables::DataTables::of(entries, {}), ros::Time(7));
  EXPECT_EQ(message.stamp, ros::Time(7));
  ASSERT_EQ(message.tools.size(), 1U);
  EXPECT_EQ(message.tools[0].index, 3);
  EXPECT_TRUE(message.frames.empty());
  ASSERT_EQ(message.loads.size(), 1U);
  EXPECT_EQ(message.loads[0].index, 15);
}

TEST(TableBoard, saysWhenEachEntryChangedAndWhetherThatWasRead) {
  tables::DataTables all;
  TableBoard board(all);
  EXPECT_FALSE(board.take(all, ros::Time(1)));
  EXPECT_TRUE(board.lastChange().isZero());
  EXPECT_EQ(all.writeFrame(2, tables::Frame{"table", std::nullopt, 0}, {}), std::nullopt);
  EXPECT_TRUE(board.take(all, ros::Time(5)));
  EXPECT_FALSE(board.take(all, ros::Time(6))) << "it is known";
  EXPECT_EQ(board.lastChange(), ros::Time(5));
  EXPECT_EQ(board.changeOf(Kind::Frame, 2), ros::Time(5));
  EXPECT_TRUE(board.changeOf(Kind::Frame, 3).isZero());
  EXPECT_TRUE(board.changeOf(Kind::Tool, 2).isZero());
  EXPECT_FALSE(board.hasChangedSinceRead(Kind::Tool, 2));
  EXPECT_TRUE(board.hasChangedSinceRead(Kind::Frame, 2));
  EXPECT_FALSE(board.hasChangedSinceRead(Kind::Frame, 2));
  EXPECT_TRUE(board.tables().entries().frames[2]);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
