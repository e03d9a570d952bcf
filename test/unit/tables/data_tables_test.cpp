#include "cobot_command/tables/data_tables.h"

#include "table_support.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace tables;
using ::testing::HasSubstr;

struct DataTablesTest : ::testing::Test {
  int write(int index, std::optional<Tool> tool) {
    return idOf(all.writeTool(index, std::move(tool), kPayload));
  }
  int write(int index, std::optional<Frame> frame) {
    return idOf(all.writeFrame(index, std::move(frame), kPayload));
  }
  int write(int index, std::optional<Load> load) { return idOf(all.writeLoad(index, load, kPayload)); }
  Refusal refusalOf(int index, Frame frame) {
    return all.writeFrame(index, std::move(frame), kPayload).value_or(Refusal{});
  }

  DataTables all;
};

TEST_F(DataTablesTest, haveFlangeRobotBaseAndNoLoadAsNumberZeroAndNothingElse) {
  EXPECT_TRUE(all.toolInFlange(0)->isApprox(arm::Pose::Identity()));
  EXPECT_TRUE(all.frameInRobotBase(0)->isApprox(arm::Pose::Identity()));
  EXPECT_EQ(all.load(0)->mass, 0);
  for (int index = 1; index < kEntryCount; ++index) {
    EXPECT_EQ(all.toolInFlange(index).error().reason, Gap::Reason::NotConfigured);
    EXPECT_EQ(all.frameInRobotBase(index).error().reason, Gap::Reason::NotConfigured);
    EXPECT_EQ(all.load(index).error().reason, Gap::Reason::NotConfigured);
  }
}

TEST_F(DataTablesTest, sayOfANumberBeyondThemThatThereIsNone) {
  for (const int index : {-1, 16}) {
    EXPECT_EQ(all.toolInFlange(index).error().reason, Gap::Reason::OutOfRange);
    EXPECT_EQ(all.frameInRobotBase(index).error().reason, Gap::Reason::OutOfRange);
    EXPECT_EQ(all.load(index).error().reason, Gap::Reason::OutOfRange);
  }
  EXPECT_EQ(all.toolInFlange(16).error().found, "there is no tool 16; allowed: 0 to 15");
}

TEST_F(DataTablesTest, giveBackWhatWasWrittenToTheFirstAndTheLastNumber) {
  for (const int index : {1, 15}) {
    EXPECT_EQ(write(index, weighing(2)), 0);
    EXPECT_EQ(write(index, toolAt(10.0 * index, index)), 0);
    EXPECT_EQ(write(index, frameAt(20.0 * index)), 0);
    EXPECT_NEAR(all.toolInFlange(index)->translation().x(), 0.010 * index, 1e-12);
    EXPECT_NEAR(all.frameInRobotBase(index)->translation().x(), 0.020 * index, 1e-12);
    EXPECT_EQ(all.load(index)->mass, 2);
  }
}

TEST_F(DataTablesTest, refuseToWriteNumberZeroAndNumbersBeyondThem) {
  for (const int index : {-1, 0, 16, 1000}) {
    EXPECT_EQ(write(index, toolAt(1)), 0x8D35) << index;
    EXPECT_EQ(write(index, frameAt(1)), 0x8D08) << index;
    EXPECT_EQ(write(index, weighing(1)), 0x8D17) << index;
  }
}

TEST_F(DataTablesTest, resolveOneLevelOfReferenceInTheRobotBase) {
  EXPECT_EQ(write(1, Frame{"", at(400, 0, 100, 0, 0, 90), 0}), 0);
  EXPECT_EQ(write(2, Frame{"", at(10, 20, 30), 1}), 0);
  EXPECT_TRUE(all.frameInRobotBase(2)->isApprox(at(380, 10, 130, 0, 0, 90), 1e-12));
}

TEST_F(DataTablesTest, refuseAFrameWhoseReferenceRefersToAnother) {
  EXPECT_EQ(write(3, frameAt(3)), 0);
  EXPECT_EQ(write(1, frameAt(1, 3)), 0);
  EXPECT_EQ(write(2, frameAt(2, 1)), table_error::kReferenceRefers);
  EXPECT_EQ(all.frameInRobotBase(2).error().reason, Gap::Reason::NotConfigured);
}

TEST_F(DataTablesTest, refuseTheSameFromTheOtherSide) {
  EXPECT_EQ(write(1, frameAt(1)), 0);
  EXPECT_EQ(write(2, frameAt(2, 1)), 0);
  EXPECT_EQ(write(3, frameAt(3)), 0);
  EXPECT_EQ(write(1, frameAt(1, 3)), table_error::kReferenceRefers);
  EXPECT_NEAR(all.frameInRobotBase(2)->translation().x(), 0.003, 1e-12) << "nothing has changed";
  EXPECT_EQ(write(1, frameAt(5)), 0) << "it may move";
  EXPECT_NEAR(all.frameInRobotBase(2)->translation().x(), 0.007, 1e-12);
}

TEST_F(DataTablesTest, refuseAReferenceToNothingToItselfAndToNoNumber) {
  EXPECT_EQ(write(2, frameAt(1, 7)), table_error::kReferenceInvalid);
  EXPECT_EQ(write(2, frameAt(1, 2)), table_error::kReferenceInvalid);
  for (const int reference : {-1, 16}) {
    EXPECT_EQ(write(2, frameAt(1, reference)), table_error::kReferenceInvalid);
  }
  EXPECT_EQ(
      describe(refusalOf(2, frameAt(1, 7))),
      "frame 2: its reference, frame 7, is not configured; allowed: 0, the robot base, or the number of "
      "another frame that is configured. Write the reference first, or refer to 0");
}

TEST_F(DataTablesTest, refuseAReferenceOfABaseOfTheProjectAsThoseStandInTheRobotBase) {
  EXPECT_EQ(write(1, frameAt(1)), 0);
  EXPECT_EQ(write(2, Frame{"table", std::nullopt, 1}), table_error::kReferenceInvalid);
  EXPECT_EQ(write(2, Frame{"table", at(1), 1}), 0) << "its own pose may stand in another frame";
}

TEST_F(DataTablesTest, emptyAnEntryThatNobodyRefersToAndNoOther) {
  EXPECT_EQ(write(1, frameAt(1)), 0);
  EXPECT_EQ(write(2, frameAt(2, 1)), 0);
  EXPECT_EQ(write(1, weighing(1)), 0);
  EXPECT_EQ(write(2, toolAt(2, 1)), 0);
  EXPECT_EQ(write(1, std::optional<Frame>()), table_error::kReferenceInvalid);
  EXPECT_EQ(write(1, std::optional<Load>()), table_error::kLoadIndex);
  EXPECT_EQ(write(2, std::optional<Frame>()), 0);
  EXPECT_EQ(write(2, std::optional<Tool>()), 0);
  EXPECT_EQ(write(1, std::optional<Frame>()), 0);
  EXPECT_EQ(write(1, std::optional<Load>()), 0);
  EXPECT_EQ(all.frameInRobotBase(1).error().reason, Gap::Reason::NotConfigured);
}

TEST_F(DataTablesTest, refuseAToolWhoseLoadIsNotThere) {
  for (const int load : {-1, 3, 16}) EXPECT_EQ(write(1, toolAt(1, load)), table_error::kLoadIndex) << load;
  EXPECT_EQ(write(3, weighing(1)), 0);
  EXPECT_EQ(write(1, toolAt(1, 3)), 0);
}

TEST_F(DataTablesTest, refuseAMassThatTheArmCannotCarry) {
  for (const double mass : {0.0, 0.35, 4.0}) EXPECT_EQ(write(1, weighing(mass)), 0) << mass;
  for (const double mass : {-0.001, 4.001, 5.0, kNan, kInf}) {
    EXPECT_EQ(write(1, weighing(mass)), table_error::kMass) << mass;
  }
  EXPECT_EQ(all.load(1)->mass, 4);
  EXPECT_THAT(describe(*all.writeLoad(1, weighing(5), kPayload)),
              HasSubstr("0 to 4 kg, the payload of tm5-900"));
}

TEST(Payload, isThatOfTheModel) {
  const Payload payload = payloadOf(*arm::ArmModel::named("tm5-900"));
  EXPECT_EQ(payload.mass, 4);
  EXPECT_EQ(payload.whose, "tm5-900");
}

TEST_F(DataTablesTest, refuseMomentsOfInertiaThatNoToolHas) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto moment = [&](double value) {
      Load load;
      load.inertia[i] = value;
      return write(1, load);
    };
    for (const double value : {0.0, 1000.0}) EXPECT_EQ(moment(value), 0) << value;
    for (const double value : {-1e-9, 1000.001, kNan, kInf}) {
      EXPECT_EQ(moment(value), table_error::kInertiaRange) << value;
    }
  }
}

TEST_F(DataTablesTest, refusePosesThatAreNotFiniteOrTooFarAway) {
  const auto far = [](double x) {
    arm::Pose pose = arm::Pose::Identity();
    pose.translation().x() = x;
    return pose;
  };
  const auto ids = [&](double x) {
    Load load;
    load.centre = far(x);
    return std::vector<int>{write(1, Tool{"", far(x), 0}), write(1, Frame{"", far(x), 0}), write(1, load)};
  };
  using ::testing::Each;
  EXPECT_THAT(ids(100), Each(0));
  EXPECT_THAT(ids(-100), Each(0));
  EXPECT_THAT(ids(100.001), Each(table_error::kCoordinateRange));
  EXPECT_THAT(ids(kNan), Each(table_error::kNotFinite));
  EXPECT_THAT(ids(-kInf), Each(table_error::kNotFinite));
}

TEST(PoseIn, takesNumbersThatAnArmCouldMean) {
  EXPECT_TRUE(poseIn({1, 2, 3, 10, 20, 30})->isApprox(at(1, 2, 3, 10, 20, 30)));
  for (std::size_t i = 0; i < 6; ++i) {
    arm::ControllerPose numbers{};
    numbers[i] = -100000;
    EXPECT_TRUE(poseIn(numbers));
    numbers[i] = 100000.001;
    EXPECT_EQ(poseIn(numbers).error().error_id, table_error::kCoordinateRange);
    for (const double value : {kNan, kInf, -kInf}) {
      numbers[i] = value;
      EXPECT_EQ(poseIn(numbers).error().error_id, table_error::kNotFinite);
    }
  }
  EXPECT_EQ(poseIn({0, kNan, 0, 0, 0, 0}).error().found, "coordinate 2 of the pose is nan");
}

TEST_F(DataTablesTest, takeNamesThatAProjectCanHave) {
  for (const std::string& name : {std::string("RobotBase"), std::string("Drehtisch \xC3\xBC"),
                                  std::string("a\"b"), std::string(255, 'n')}) {
    EXPECT_EQ(write(1, Tool{name, std::nullopt, 0}), 0) << name;
    EXPECT_EQ(write(1, Frame{name, at(1), 0}), 0) << name;
  }
  for (const std::string& name : {std::string(256, 'n'), std::string("a\r\nScriptExit()"),
                                  std::string("\xC3"), std::string("a\0b", 3)}) {
    EXPECT_EQ(write(1, Tool{name, std::nullopt, 0}), table_error::kNameInvalid);
    EXPECT_EQ(write(1, Frame{name, at(1), 0}), table_error::kNameInvalid);
  }
  EXPECT_EQ(write(1, Tool{}), table_error::kNameInvalid) << "neither name nor pose";
}

TEST_F(DataTablesTest, sayOfANameWithoutAValueThatOnlyTheProjectKnowsIt) {
  EXPECT_EQ(write(3, Tool{"gripper", std::nullopt, 0}), 0);
  const Gap gap = all.toolInFlange(3).error();
  EXPECT_EQ(gap.reason, Gap::Reason::ValueUnknown);
  EXPECT_EQ(gap.name, "gripper");
  EXPECT_EQ(gap.found, "tool 3 is \"gripper\" of the controller's project, whose value is not known");
}

TEST_F(DataTablesTest, sayWhichFrameLacksItsValueWhenItIsTheReference) {
  EXPECT_EQ(write(1, Frame{"table", std::nullopt, 0}), 0);
  EXPECT_EQ(write(2, frameAt(5, 1)), 0);
  const Gap gap = all.frameInRobotBase(2).error();
  EXPECT_EQ(gap.reason, Gap::Reason::ValueUnknown);
  EXPECT_EQ(gap.index, 1);
  EXPECT_THAT(gap.found, HasSubstr("frame 2 refers to another: frame 1"));
}

TEST_F(DataTablesTest, learnAValueOfTheProjectAndKeepTheirOwn) {
  EXPECT_EQ(write(1, Tool{"gripper", std::nullopt, 0}), 0);
  EXPECT_EQ(write(2, Tool{"gripper", at(2), 0}), 0);
  EXPECT_EQ(write(1, Frame{"table", std::nullopt, 0}), 0);
  all.learnTool("gripper", at(1));
  all.learnTool("another", at(7));
  all.learnFrame("table", at(4));
  EXPECT_TRUE(all.toolInFlange(1)->isApprox(at(1)));
  EXPECT_TRUE(all.toolInFlange(2)->isApprox(at(2)));
  EXPECT_TRUE(all.frameInRobotBase(1)->isApprox(at(4)));
}

TEST_F(DataTablesTest, leaveCopiesAsTheyAre) {
  EXPECT_EQ(write(1, toolAt(1)), 0);
  const DataTables copy = all;
  EXPECT_EQ(&copy.entries(), &all.entries()) << "a copy costs nothing";
  EXPECT_EQ(write(1, toolAt(2)), 0);
  EXPECT_NEAR(copy.toolInFlange(1)->translation().x(), 0.001, 1e-12);
}

TEST(DataTablesOf, areCheckedTogetherInWhateverOrder) {
  Entries entries;
  entries.frames[2] = frameAt(2, 9);
  entries.frames[9] = frameAt(9);
  entries.tools[1] = toolAt(1, 5);
  entries.loads[5] = weighing(1);
  EXPECT_TRUE(DataTables::of(entries, kPayload));
  entries.frames[9] = frameAt(9, 2);
  EXPECT_EQ(DataTables::of(entries, kPayload).error().error_id, table_error::kReferenceRefers);
}

TEST(DataTablesOf, keepNumberZeroFixed) {
  Entries entries;
  entries.tools[0] = toolAt(50);
  entries.frames[0].reset();
  const auto tables = DataTables::of(entries, kPayload);
  EXPECT_TRUE(tables->toolInFlange(0)->isApprox(arm::Pose::Identity()));
  EXPECT_TRUE(tables->frameInRobotBase(0));
}

}  // namespace
}  // namespace cobot_command::testing
