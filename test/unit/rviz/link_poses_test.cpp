#include "displays/link_poses.h"

#include <array>
#include <cmath>

#include "source_tree.h"
#include <gmock/gmock.h>
#include <urdf_parser/urdf_parser.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kDegree = M_PI / 180;

urdf::ModelInterfaceSharedPtr arm() {
  return urdf::parseURDFFile(test_support::inSourceTree("urdf/tm5-700.urdf"));
}

std::map<std::string, double> named(const std::array<double, 6>& degrees) {
  constexpr std::array kNames{"shoulder_1_joint", "shoulder_2_joint", "elbow_joint",
                              "wrist_1_joint",    "wrist_2_joint",    "wrist_3_joint"};
  std::map<std::string, double> joints;
  for (std::size_t i = 0; i < kNames.size(); ++i) joints[kNames[i]] = degrees[i] * kDegree;
  return joints;
}

TEST(LinkPoses, bringTheFlangeWhereTheControllerHasIt) {
  ASSERT_TRUE(arm());
  const auto poses = linkPoses(*arm(), named({30, -20, 100, 10, 80, -45}));
  EXPECT_THAT(arm::toControllerPose(poses.at("tool0")),
              Pointwise(DoubleNear(0.001), {330.992, 27.191, 397.019, -172.893, 7.053, 165.439}));
}

TEST(LinkPoses, takeJointsThatAreNotNamedAsZero) {
  EXPECT_TRUE(
      linkPoses(*arm(), {}).at("tool0").isApprox(linkPoses(*arm(), named({0, 0, 0, 0, 0, 0})).at("tool0")));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
