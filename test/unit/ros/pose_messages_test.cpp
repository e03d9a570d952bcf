#include <gmock/gmock.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kNear = 1e-9;

TEST(PoseMessages, areTheSameThereAndBack) {
  for (const auto& six :
       {std::array<double, 6>{430, -220, 380, 180, 0, 90}, {1, 2, 3, -170, 45, -30}, {0, 0, 0, 0, 0, 0}}) {
    const arm::Pose pose = arm::toPose(six);
    EXPECT_TRUE(arm::toPose(arm::toControllerPose(pose)).isApprox(pose, kNear));
    EXPECT_TRUE(toPose(toPoseMessage(pose)).isApprox(pose, kNear));
  }
}

TEST(PoseMessages, turnAboutFixedAxesXThenYThenZ) {
  const arm::Pose pose = arm::toPose(arm::ControllerPose{0, 0, 0, 90, 0, 90});
  // Its own y looks up after the turn about x, and stays so; its own x goes to y.
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ(), kNear));
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), kNear));
}

TEST(PoseMessages, haveNumbersAlsoWhereTheToolLooksSideways) {
  const arm::Pose pose = arm::toPose(arm::ControllerPose{100, 0, 0, 20, 90, 50});
  const auto six = arm::toControllerPose(pose);
  EXPECT_NEAR(six[4], 90, 1e-5);
  EXPECT_TRUE(arm::toPose(six).isApprox(pose, 1e-6));
}

TEST(PoseMessages, areUpsetByNoQuaternionOfZeroLength) {
  geometry_msgs::Pose pose;
  pose.position.x = 1;
  EXPECT_THAT(arm::toControllerPose(toPose(pose)), Pointwise(DoubleNear(kNear), {1000., 0., 0., 0., 0., 0.}));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
