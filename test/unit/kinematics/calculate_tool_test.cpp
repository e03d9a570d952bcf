// A TCP of poses of the flange that touch one point.

#include "cobot_command/kinematics/calculate_tool.h"

#include <random>

#include "kinematics_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::kinematics {
namespace {

using ::testing::HasSubstr;
using ::testing::Pointwise;

const Eigen::Vector3d kTcp(0.012, -0.034, 0.187), kPoint(0.4, -0.1, 0.05);

/// Where the flange is when it is so turned and its TCP touches the point, but for an error [mm].
arm::ControllerPose touching(double rx, double ry, double rz,
                             const Eigen::Vector3d& error = Eigen::Vector3d::Zero()) {
  arm::Pose flange = arm::toPose({0, 0, 0, rx, ry, rz});
  flange.translation() = kPoint - flange.linear() * kTcp + error * 1e-3;
  return arm::toControllerPose(flange);
}

ToolQuestion fourTouches() {
  return {{touching(180, 0, 0), touching(210, 0, 30), touching(150, 20, -40), touching(180, -30, 100)}};
}

void expectRefused(int error_id, const char* words, const ToolQuestion& question) {
  const auto answer = calculateTool(question);
  ASSERT_FALSE(answer) << words;
  EXPECT_EQ(answer.error().error_id, error_id) << answer.error().message;
  EXPECT_THAT(answer.error().message, HasSubstr(words));
}

TEST(CalculateTool, findsTheTcpAndThePointOfFourTouches) {
  const auto answer = calculateTool(fourTouches());
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_THAT(answer->tcp, Pointwise(testing::DoubleNear(1e-6), arm::ControllerPose{12, -34, 187, 0, 0, 0}));
  EXPECT_THAT(answer->point,
              Pointwise(testing::DoubleNear(1e-6), arm::ControllerPose{400, -100, 50, 0, 0, 0}));
  EXPECT_LT(answer->worst_error, 1e-6);
}

TEST(CalculateTool, evensOutTheErrorsOfManyTouches) {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> tilt(-40, 40), turn(-180, 180), error(-0.2, 0.2);
  ToolQuestion question;
  while (question.flanges.size() < 60) {
    const Eigen::Vector3d off(error(generator), error(generator), error(generator));
    question.flanges.push_back(touching(180 + tilt(generator), tilt(generator), turn(generator), off));
    const auto added = calculateTool(question);
    if (!added && added.error().error_id == 0x8C59) question.flanges.pop_back();
  }
  const auto answer = calculateTool(question);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_THAT(answer->tcp, Pointwise(testing::DoubleNear(0.15), arm::ControllerPose{12, -34, 187, 0, 0, 0}));
  EXPECT_NEAR(answer->mean_error, 0.2, 0.05) << "that of three equal distributions";
  EXPECT_GT(answer->worst_error, answer->mean_error);
  EXPECT_LT(answer->worst_error, 0.5);
}

TEST(CalculateTool, leavesNoSmallerErrorWithAnyOtherTcp) {
  ToolQuestion question = fourTouches();
  question.flanges.push_back(touching(200, 25, -120, {1, 2, -1.5}));
  const auto best = calculateTool(question);
  ASSERT_TRUE(best);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double off : {-0.1, 0.1}) {
      Eigen::Vector3d tcp(best->tcp[0], best->tcp[1], best->tcp[2]);
      tcp[static_cast<Eigen::Index>(axis)] += off;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& flange : question.flanges) mean += arm::toPose(flange) * (tcp * 1e-3) / 5;
      double sum = 0;
      for (const auto& flange : question.flanges) {
        sum += (arm::toPose(flange) * (tcp * 1e-3) - mean).squaredNorm();
      }
      EXPECT_GT(std::sqrt(sum / 5) * 1e3, best->mean_error);
    }
  }
}

TEST(CalculateTool, refusesCountsThatAreTooSmallOrTooLarge) {
  ToolQuestion question = fourTouches();
  question.flanges.pop_back();
  expectRefused(0x8C66, "there are 3 poses; allowed: 4 to 100", question);
  question.flanges.assign(101, touching(180, 0, 0));
  expectRefused(0x8C65, "there are 101 poses", question);
  expectRefused(0x8C66, "there are 0 poses", {});
}

TEST(CalculateTool, refusesPosesThatAreTurnedTooLittle) {
  ToolQuestion question = fourTouches();
  question.flanges[3] = touching(210, 0, 34.9);
  expectRefused(0x8C59, "the poses 2 and 4", question);
}

TEST(CalculateTool, refusesPosesThatAreTurnedAboutOneAxis) {
  expectRefused(0x8C61, "about one axis",
                {{touching(180, 0, 0), touching(180, 0, 40), touching(180, 0, 80), touching(180, 0, 120)}});
  expectRefused(0x8C61, "about one axis",
                {{touching(180, 0, 0), touching(181, 0, 40), touching(180, 1, 80), touching(179, 0, 120)}});
}

TEST(CalculateTool, refusesTouchesOfDifferentPoints) {
  ToolQuestion question = fourTouches();
  question.flanges.push_back(touching(200, 25, -120, {60, 0, 0}));
  expectRefused(0x8C60, "mm from one point; allowed: 5 mm", question);
  question.most_error = 100;
  EXPECT_TRUE(calculateTool(question));
}

TEST(CalculateTool, refusesNumbersThatAreNone) {
  ToolQuestion question = fourTouches();
  question.flanges[2][4] = kNan;
  expectRefused(0x200, "pose 3", question);
  question.flanges[2][4] = 1e6;
  expectRefused(0x213, "pose 3", question);
  question = fourTouches();
  question.most_error = -1;
  expectRefused(0x213, "most_error", question);
  question.most_error = kNan;
  expectRefused(0x200, "most_error", question);
}

}  // namespace
}  // namespace cobot_command::kinematics
