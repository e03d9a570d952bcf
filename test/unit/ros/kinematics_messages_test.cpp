// Questions of the kinematics and their answers, field by field.

#include "kinematics/kinematics_messages.h"

#include <gmock/gmock.h>

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using kinematics::Posture;
using ::testing::ElementsAre;

const arm::PoseBits kLeftyBelowFlip = *arm::PoseBits::fromNumbers(1, 3, 5);

Posture posture(double joint_1) {
  return {{joint_1, 2, 3, 4, 5, 6}, kLeftyBelowFlip, {1, 0, 0, 0, 0, -1}};
}

void expectPosture(const cobot_command::ArmPosture& message, double joint_1) {
  EXPECT_THAT(message.joints, ElementsAre(joint_1, 2, 3, 4, 5, 6));
  EXPECT_THAT(message.turns, ElementsAre(1, 0, 0, 0, 0, -1));
  EXPECT_EQ(message.bits.config1, 1);
  EXPECT_EQ(message.bits.config2, 3);
  EXPECT_EQ(message.bits.config3, 5);
}

TEST(KinematicsMessages, askForwardWithEveryField) {
  cobot_command::ForwardKinematics::Request request;
  request.joints = {{1, 2, 3, 4, 5, 6}};
  request.tool = 7;
  request.frame = 8;
  const auto question = toQuestion(request);
  EXPECT_EQ(question.joints, (arm::ControllerJoints{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(question.numbers.tool, 7);
  EXPECT_EQ(question.numbers.frame, 8);
}

TEST(KinematicsMessages, askInverseWithEveryField) {
  cobot_command::InverseKinematics::Request request;
  request.pose = toTransformation({1, 2, 3, 4, 5, 6});
  request.tool = 7;
  request.frame = 8;
  request.configuration = cobot_command::InverseKinematics::Request::FREE;
  request.bits.config1 = 1;
  request.bits.config2 = 3;
  request.bits.config3 = 5;
  request.joints = {{10, 20, 30, 40, 50, 60}};
  const auto question = toQuestion(request);
  EXPECT_EQ(question.pose, (arm::ControllerPose{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(question.numbers.tool, 7);
  EXPECT_EQ(question.numbers.frame, 8);
  EXPECT_EQ(question.configuration, static_cast<int>(kinematics::Configuration::Free));
  EXPECT_EQ(question.bits, (std::array<int, 3>{1, 3, 5}));
  EXPECT_EQ(question.joints, (arm::ControllerJoints{10, 20, 30, 40, 50, 60}));
}

TEST(KinematicsMessages, nameTheConfigurationsAsTheCoreDoes) {
  using Request = cobot_command::InverseKinematics::Request;
  EXPECT_EQ(static_cast<int>(Request::GIVEN), static_cast<int>(kinematics::Configuration::Given));
  EXPECT_EQ(static_cast<int>(Request::SAME), static_cast<int>(kinematics::Configuration::Same));
}

TEST(KinematicsMessages, answerForwardWithEveryField) {
  const auto response = toResponse(kinematics::ForwardAnswer{{1, 2, 3, 4, 5, 6}, posture(200)});
  EXPECT_TRUE(response.success);
  EXPECT_EQ(response.error_id, 0);
  EXPECT_EQ(toSix(response.pose), (arm::ControllerPose{1, 2, 3, 4, 5, 6}));
  expectPosture(response.posture, 200);
  EXPECT_TRUE(response.posture.within_limits);
}

TEST(KinematicsMessages, answerInverseWithAllBranchesAlsoWhereNoneWasChosen) {
  kinematics::InverseAnswer answer{{{posture(200), std::nullopt}, {posture(-200), 3}}, posture(200)};
  auto response = toResponse(answer);
  EXPECT_TRUE(response.success);
  expectPosture(response.posture, 200);
  ASSERT_EQ(response.branches.size(), 2U);
  expectPosture(response.branches[1], -200);
  EXPECT_TRUE(response.branches[0].within_limits);
  EXPECT_EQ(response.branches[0].outside, 0);
  EXPECT_FALSE(response.branches[1].within_limits);
  EXPECT_EQ(response.branches[1].outside, 4) << "J4";
  answer.chosen = refuse(kinematics::Refusal{0x8C63, "why"});
  response = toResponse(answer);
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.error_id, 0x8C63);
  EXPECT_EQ(response.message, "why");
  EXPECT_EQ(response.branches.size(), 2U);
}

TEST(KinematicsMessages, askForAFrameWithEveryField) {
  cobot_command::CalculateFrame::Request request;
  request.origin.x = 1;
  request.on_x_axis.y = 2;
  request.in_xy_plane.z = 3;
  request.frame = 4;
  request.reference = 5;
  const auto question = toQuestion(request);
  EXPECT_EQ(question.origin[0], 1);
  EXPECT_EQ(question.on_x_axis[1], 2);
  EXPECT_EQ(question.in_xy_plane[2], 3);
  EXPECT_EQ(question.frame, 4);
  EXPECT_EQ(question.reference, 5);
}

TEST(KinematicsMessages, askForAToolAndAnswerWithEveryField) {
  cobot_command::CalculateTool::Request request;
  request.flanges = {toTransformation({1, 2, 3, 4, 5, 6}), toTransformation({7, 8, 9, 10, 11, 12})};
  request.most_error = 0.5;
  const auto question = toQuestion(request);
  EXPECT_THAT(question.flanges,
              ElementsAre(arm::ControllerPose{1, 2, 3, 4, 5, 6}, arm::ControllerPose{7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(question.most_error, 0.5);
  const auto response = toResponse(kinematics::ToolAnswer{{1, 2, 3, 0, 0, 0}, {4, 5, 6, 0, 0, 0}, 0.1, 0.2});
  EXPECT_TRUE(response.success);
  EXPECT_EQ(response.tcp.z, 3);
  EXPECT_EQ(response.point.x, 4);
  EXPECT_EQ(response.mean_error, 0.1);
  EXPECT_EQ(response.worst_error, 0.2);
}

TEST(KinematicsMessages, answerWithTheRefusal) {
  const auto response = toResponse(Result<kinematics::ForwardAnswer, kinematics::Refusal>(
      refuse(kinematics::Refusal{0x8D35, "tool 7 is not configured"})));
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.error_id, 0x8D35);
  EXPECT_EQ(response.message, "tool 7 is not configured");
}

}  // namespace
}  // namespace cobot_command::ros_adapter
