// A frame of three touched points.

#include "cobot_command/kinematics/calculate_frame.h"

#include <random>

#include "kinematics_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::kinematics {
namespace {

using ::testing::HasSubstr;
using ::testing::Pointwise;

testing::Matcher<arm::ControllerPose> near(const arm::ControllerPose& pose) {
  return Pointwise(testing::DoubleNear(1e-6), pose);
}

/// Where a tool is that touches a point of the frame; how it is turned does not matter.
arm::ControllerPose touched(const arm::ControllerPose& frame, double x, double y) {
  arm::ControllerPose pose = arm::toControllerPose(arm::toPose(frame) * arm::toPose({x, y, 0, 0, 0, 0}));
  pose[3] += 12;
  pose[5] -= 34;
  return pose;
}

class CalculateFrame : public ::testing::Test {
 protected:
  void expectRefused(int error_id, const char* words, const FrameQuestion& question) {
    const auto answer = calculateFrame(tables, question);
    ASSERT_FALSE(answer) << words;
    EXPECT_EQ(answer.error().error_id, error_id) << answer.error().message;
    EXPECT_THAT(answer.error().message, HasSubstr(words));
  }

  const tables::DataTables tables = someTables();
  const FrameQuestion square{{100, 200, 50, 0, 0, 0}, {100, 500, 50, 0, 0, 0}, {-200, 200, 50, 0, 0, 0}};
};

TEST_F(CalculateFrame, hasItsOriginItsXAxisAndItsPlaneThroughThePoints) {
  const auto answer = calculateFrame(tables, square);
  ASSERT_TRUE(answer);
  EXPECT_THAT(*answer, near({100, 200, 50, 0, 0, 90}));
}

TEST_F(CalculateFrame, findsAnyFrameAgain) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> place(-900, 900), angle(-80, 80), along(20, 400);
  for (int round = 0; round < 1000; ++round) {
    const arm::ControllerPose frame = {place(generator), place(generator), place(generator),
                                       angle(generator), angle(generator), angle(generator)};
    const auto answer = calculateFrame(tables, {touched(frame, 0, 0), touched(frame, along(generator), 0),
                                                touched(frame, place(generator), along(generator))});
    ASSERT_TRUE(answer) << answer.error().message;
    EXPECT_THAT(*answer, near(frame));
  }
}

TEST_F(CalculateFrame, takesPointsInOneFrameAndTellsItInAnother) {
  FrameQuestion question = square;
  question.frame = 2;
  question.reference = 1;
  const arm::Pose in_robot = *tables.frameInRobotBase(2) * arm::toPose({100, 200, 50, 0, 0, 90});
  const auto answer = calculateFrame(tables, question);
  ASSERT_TRUE(answer);
  EXPECT_THAT(*answer, near(arm::toControllerPose(tables.frameInRobotBase(1)->inverse() * in_robot)));
}

TEST_F(CalculateFrame, refusesPointsThatAreTooNear) {
  FrameQuestion question = square;
  question.on_x_axis = {100, 209.9, 50, 0, 0, 0};
  expectRefused(0x8C59, "the origin and the point on the x axis are 9.900 mm apart", question);
  question = square;
  question.in_xy_plane = question.origin;
  expectRefused(0x8C59, "the origin and the point in the xy plane", question);
  question.in_xy_plane = question.on_x_axis;
  expectRefused(0x8C59, "on the x axis and in the xy plane", question);
}

TEST_F(CalculateFrame, refusesPointsOnOneLine) {
  FrameQuestion question = square;
  question.in_xy_plane = {95, -300, 50, 0, 0, 0};
  expectRefused(0x8C61, "5.000 mm from the x axis", question);
}

TEST_F(CalculateFrame, refusesNumbersAndFramesThatAreNone) {
  FrameQuestion question = square;
  question.in_xy_plane[1] = kNan;
  expectRefused(0x200, "the point in the xy plane", question);
  question = square;
  question.origin[2] = 1e6;
  expectRefused(0x213, "the origin", question);
  for (const int number : {-1, 16, 7, 3}) {
    question = square;
    question.frame = number;
    expectRefused(0x8D08, "frame", question);
    question = square;
    question.reference = number;
    expectRefused(0x8D08, "frame", question);
  }
}

}  // namespace
}  // namespace cobot_command::kinematics
