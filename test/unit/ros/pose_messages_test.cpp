#include "goals/poses.h"

#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kNear = 1e-9;

TEST(Poses, areTheSameThereAndBack) {
  for (const auto& six :
       {std::array<double, 6>{430, -220, 380, 180, 0, 90}, {1, 2, 3, -170, 45, -30}, {0, 0, 0, 0, 0, 0}}) {
    const Eigen::Isometry3d pose = toIsometry(six);
    EXPECT_TRUE(toIsometry(toSix(pose)).isApprox(pose, kNear));
    EXPECT_TRUE(toIsometry(toPose(pose)).isApprox(pose, kNear));
  }
}

TEST(Poses, turnAboutFixedAxesXThenYThenZ) {
  const Eigen::Isometry3d pose = toIsometry(std::array<double, 6>{0, 0, 0, 90, 0, 90});
  // Its own y looks up after the turn about x, and stays so; its own x goes to y.
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitZ(), kNear));
  EXPECT_TRUE((pose.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), kNear));
}

TEST(Poses, haveNumbersAlsoWhereTheToolLooksSideways) {
  const Eigen::Isometry3d pose = toIsometry(std::array<double, 6>{100, 0, 0, 20, 90, 50});
  const auto six = toSix(pose);
  EXPECT_NEAR(six[4], 90, 1e-5);
  EXPECT_TRUE(toIsometry(six).isApprox(pose, 1e-6));
}

TEST(Poses, areUpsetByNoQuaternionOfZeroLength) {
  geometry_msgs::Pose pose;
  pose.position.x = 1;
  EXPECT_THAT(toSix(toIsometry(pose)), Pointwise(DoubleNear(kNear), {1000., 0., 0., 0., 0., 0.}));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
