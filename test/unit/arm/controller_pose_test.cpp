#include "cobot_command/arm/controller_pose.h"

#include <cmath>
#include <random>

#include "arm_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::arm {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

double angleBetween(const Pose& a, const Pose& b) {
  // The sine, not the angle's cosine: small angles keep their digits.
  const Eigen::Matrix3d r = a.linear().transpose() * b.linear();
  return Eigen::Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)).norm() / 2;
}

TEST(ControllerPose, turnsAboutTheFixedAxesXThenYThenZ) {
  // X of the tool goes to Y by RZ; Z of the tool goes to -Y by RX and then to X by RZ.
  const Pose pose = toPose({100, 200, 300, 90, 0, 90});
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_TRUE(pose.linear().col(0).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(pose.linear().col(2).isApprox(Eigen::Vector3d::UnitX()));
}

TEST(ControllerPose, survivesTheRoundTrip) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> mm(-1500, 1500);
  std::uniform_real_distribution<double> turn(-180, 180);
  std::uniform_real_distribution<double> half_turn(-90, 90);
  for (int i = 0; i < 10000; ++i) {
    const ControllerPose pose = {mm(generator),   mm(generator),        mm(generator),
                                 turn(generator), half_turn(generator), turn(generator)};
    const ControllerPose back = toControllerPose(toPose(pose));
    EXPECT_LT(angleBetween(toPose(back), toPose(pose)), 1e-14);
    // Angles lose digits towards gimbal lock, the orientation does not.
    EXPECT_THAT(back, Pointwise(DoubleNear(1e-11 / std::cos(degToRad(pose[4]))), pose));
  }
}

TEST(ControllerPose, reportsZeroRzAtGimbalLock) {
  EXPECT_THAT(toControllerPose(toPose({0, 0, 0, 30, 90, 10})),
              Pointwise(DoubleNear(1e-9), ControllerPose{0, 0, 0, 20, 90, 0}));
  EXPECT_THAT(toControllerPose(toPose({0, 0, 0, 30, -90, 10})),
              Pointwise(DoubleNear(1e-9), ControllerPose{0, 0, 0, 40, -90, 0}));
  EXPECT_EQ(toControllerPose(toPose({0, 0, 0, -170, 90, 30}))[5], 0);
}

TEST(ControllerPose, keepsTheOrientationAtEveryDistanceFromGimbalLock) {
  for (const double sign : {1.0, -1.0}) {
    for (const double offset : {1e-1, 1e-3, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 0.0}) {
      for (int rx = -175; rx < 180; rx += 35) {
        const Pose pose = toPose({0, 0, 0, 1.0 * rx, sign * (90 - offset), 47 - 0.5 * rx});
        EXPECT_LT(angleBetween(toPose(toControllerPose(pose)), pose), 2e-10) << offset << ' ' << rx;
      }
    }
  }
}

TEST(ControllerPose, reportsHalfATurnAsPlus180) {
  EXPECT_THAT(toControllerPose(toPose({0, 0, 0, -180, 0, -180})),
              Pointwise(DoubleNear(1e-12), ControllerPose{0, 0, 0, 180, 0, 180}));
  const Pose half_turn(Eigen::Isometry3d(Eigen::AngleAxisd(-kPi, Eigen::Vector3d::UnitX())));
  EXPECT_DOUBLE_EQ(toControllerPose(half_turn)[3], 180);
}

TEST(ControllerPose, neverReportsMinus180OrMinusZero) {
  for (int rx = -360; rx <= 360; rx += 45) {
    for (int ry = -360; ry <= 360; ry += 45) {
      for (int rz = -360; rz <= 360; rz += 45) {
        const Pose pose = toPose({-0.0, -0.0, -0.0, 1.0 * rx, 1.0 * ry, 1.0 * rz});
        const ControllerPose reported = toControllerPose(pose);
        for (const double value : reported) {
          EXPECT_FALSE(value == 0 && std::signbit(value));
          EXPECT_GT(value, -180);
          EXPECT_LE(value, 180);
        }
        EXPECT_LT(angleBetween(toPose(reported), pose), 1e-14);
      }
    }
  }
}

TEST(ControllerJoints, areDegreesOfTheJointVector) {
  const ControllerJoints degrees = {-270, -180, -0.0, 90, 180, 270};
  const JointVector joints = toJointVector(degrees);
  EXPECT_DOUBLE_EQ(joints[0], -1.5 * kPi);
  EXPECT_DOUBLE_EQ(joints[3], kPi / 2);
  EXPECT_THAT(toControllerJoints(joints), Pointwise(DoubleNear(1e-12), degrees));
  EXPECT_FALSE(std::signbit(toControllerJoints(joints)[2]));
}

}  // namespace
}  // namespace cobot_command::arm
