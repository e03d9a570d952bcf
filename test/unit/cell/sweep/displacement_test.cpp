#include "cobot_command/cell/sweep/displacement.h"

#include <algorithm>

#include "cell_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

constexpr int kBoxes = 400;
constexpr int kSamples = 60;

/// Of all points of a capsule that moves rigidly: at most this, as a turn moves the points of a ball around
/// an end by no more than the turn of its radius.
Eigen::Vector3d randomPointOf(RandomNumbers& random, const Capsule& capsule) {
  const Eigen::Vector3d direction = random.point(1).normalized();
  return capsule.from + random.within(0, 1) * (capsule.to - capsule.from) + capsule.radius * direction;
}

/// The farthest that a point of a body moved, in parts of the bound of the body.
double largestPart(const RobotBodies& robot, double half_width) {
  RandomNumbers random(17);
  double largest = 0;
  for (int box = 0; box < kBoxes; ++box) {
    const arm::JointVector centre = random.joints(3);
    arm::JointVector widths = random.joints(half_width).cwiseAbs();
    if (box % 3 == 0) widths = widths.cwiseProduct(arm::JointVector::Unit(box % 6));
    const arm::LinkFrames before = robot.chain().framesAt(centre, robot.base());
    const PlacedRobot placed = robot.at(centre);
    for (int i = 0; i < kSamples; ++i) {
      const arm::JointVector part = random.joints(1);
      const bool corner = random.coin();
      const arm::JointVector moved =
          corner ? widths.cwiseProduct(part.cwiseSign()).eval() : widths.cwiseProduct(part);
      const arm::LinkFrames behind = robot.chain().framesAt(centre + moved, robot.base());
      for (std::size_t k = 0; k < robot.bodies().size(); ++k) {
        const Body& body = robot.bodies()[k];
        const double bound = displacementBound(placed.capsules[k], body.link, placed.axes, widths);
        const Eigen::Vector3d point = randomPointOf(random, body.capsule);
        const double way = (behind[body.link] * point - before[body.link] * point).norm();
        if (body.link == 0) {
          EXPECT_EQ(bound, 0);
        } else if (bound > 0) {
          largest = std::max(largest, way / bound);
        } else {
          EXPECT_LT(way, 1e-12);
        }
      }
    }
  }
  return largest;
}

TEST(Displacement, noPointOfABodyMovesFartherAndHalfOfItWouldNotDo) {
  const RobotBodies robot = robotAt({100, 200, 300, 10, 20, 30});
  for (const double half_width : {0.001, 0.05, 0.5, 2.0}) {
    const double part = largestPart(robot, half_width);
    EXPECT_LE(part, 1 + 1e-9) << half_width;
    EXPECT_GT(part, 0.5) << half_width;
  }
}

TEST(Displacement, isThatOfAnArcWhereOneJointMoves) {
  const RobotBodies robot = robotAt({0, 0, 0, 0, 0, 0});
  const PlacedRobot placed = robot.at(arm::toJointVector({0, 45, 60, -15, 90, 0}));
  const Capsule& tool = placed.capsules.back();
  const double lever = std::max(tool.from.head<2>().norm(), tool.to.head<2>().norm()) + tool.radius;
  const arm::JointVector widths = 0.01 * arm::JointVector::Unit(0);
  EXPECT_NEAR(displacementBound(tool, 6, placed.axes, widths), 0.01 * lever, 1e-12);
  EXPECT_GE(largestDisplacement(robot, placed, widths), 0.01 * lever - 1e-12);
}

}  // namespace
}  // namespace cobot_command::cell
