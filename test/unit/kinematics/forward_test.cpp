// Joints -> the pose of a tool in a frame.

#include "cobot_command/kinematics/forward.h"

#include "kinematics_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::kinematics {
namespace {

using ::testing::HasSubstr;

constexpr std::array<int, 3> kRightyAboveNoFlip = {0, 2, 4};

class Forward : public ::testing::Test {
 protected:
  Result<ForwardAnswer, Refusal> of(const arm::ControllerJoints& joints, ToolAndFrame numbers = {}) {
    return forward(arm, tables, {joints, numbers});
  }
  void expectRefused(int error_id, const char* words, const arm::ControllerJoints& joints,
                     ToolAndFrame numbers = {}) {
    const auto answer = of(joints, numbers);
    ASSERT_FALSE(answer) << words;
    EXPECT_EQ(answer.error().error_id, error_id) << answer.error().message;
    EXPECT_THAT(answer.error().message, HasSubstr(words));
  }

  const arm::ArmModel arm = model("tm5-700");
  const tables::DataTables tables = someTables();
};

TEST_F(Forward, givesThePoseTheBitsAndTheTurnsOfTheOracle) {
  const auto answer = of(kJoints);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->pose, testing::Pointwise(testing::DoubleNear(1e-3), kPoseOf700));
  EXPECT_EQ(answer->posture.joints, kJoints);
  EXPECT_EQ(answer->posture.bits.numbers(), kRightyAboveNoFlip);
  EXPECT_EQ(answer->posture.turns, Turns{});
}

TEST_F(Forward, tellsTheTurnOfAJointThatHasGoneRound) {
  const auto answer = of({200, -20, 100, 10, 80, -260});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->posture.turns, (Turns{1, 0, 0, 0, 0, -1}));
}

TEST_F(Forward, hasTheToolOfTheTablesInTheFrameOfTheTables) {
  const arm::Pose flange = arm::toPose(of(kJoints)->pose);
  const arm::Pose tool = *tables.toolInFlange(1);
  for (const int frame : {0, 1, 2}) {
    const auto answer = of(kJoints, {1, frame});
    ASSERT_TRUE(answer);
    const arm::Pose expected = tables.frameInRobotBase(frame)->inverse() * flange * tool;
    EXPECT_LT((arm::toPose(answer->pose).matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 1e-9) << frame;
  }
}

TEST_F(Forward, usesWhatTheStoreHasLearnedOfTheProject) {
  tables::DataTables learned = tables;
  learned.learnTool("gripper", arm::toPose({0, 0, 150, 0, 0, 30}));
  learned.learnFrame("table", arm::toPose({100, -200, 50, 10, 0, 90}));
  const auto answer = forward(arm, learned, {kJoints, {2, 3}});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->pose, of(kJoints, {1, 1})->pose);
}

TEST_F(Forward, refusesToolsWithoutAKnownPose) {
  for (const int tool : {-1, 16}) expectRefused(0x8D35, "0 to 15", kJoints, {tool, 0});
  expectRefused(0x8D35, "tool 7 is not configured", kJoints, {7, 0});
  expectRefused(0x8D35, "\"gripper\" of the controller's project", kJoints, {2, 0});
}

TEST_F(Forward, refusesFramesWithoutAKnownPose) {
  for (const int frame : {-1, 16}) expectRefused(0x8D08, "0 to 15", kJoints, {0, frame});
  expectRefused(0x8D08, "frame 7 is not configured", kJoints, {0, 7});
  expectRefused(0x8D08, "\"table\" of the controller's project", kJoints, {0, 3});
  expectRefused(0x8D08, "frame", kJoints, {-1, -1});
}

TEST_F(Forward, refusesWhatIsNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    for (std::size_t i = 0; i < kJoints.size(); ++i) {
      arm::ControllerJoints joints = kJoints;
      joints[i] = bad;
      expectRefused(0x200, "finite", joints);
    }
  }
}

TEST_F(Forward, refusesAJointOutsideTheLimitsOfTheModelThatItIsGiven) {
  expectRefused(0x8C63, "joint 3 is at 160.000 degrees; allowed: -155.000 to 155.000", {0, 0, 160, 0, 90, 0});
  expectRefused(0x8C63, "joint 1", {1e300, 0, 90, 0, 90, 0});
  EXPECT_TRUE(of({0, 0, 155, 0, 90, 0})) << "at the limit";
  const arm::ArmModel narrow = narrowed("tm5-700", "shoulder_1_joint", -20, 20);
  const auto answer = forward(narrow, tables, {kJoints, {}});
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error().message, HasSubstr("joint 1 is at 30.000 degrees"));
}

}  // namespace
}  // namespace cobot_command::kinematics
