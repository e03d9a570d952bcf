// The claim of a box of joints contains the robot at all joints in it, and no more than it says.
#include "cobot_command/cell/sweep/robot_claim.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_test_support.h"
#include <gtest/gtest.h>

#include "cobot_command/cell/sweep/capsule_claim.h"
#include "cobot_command/cell/sweep/displacement.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;

/// Voxels so small, and displacements so large, that half of them can be told from all of them.
constexpr double kEdge = 0.005;
constexpr double kBound = 0.050;

struct Box {
  arm::JointVector centre;
  arm::JointVector half_widths;
};

/// As wide as the bound of a piece allows; every third moves one joint alone.
Box randomBox(RandomNumbers& random, const RobotBodies& robot, int number) {
  Box box{random.joints(3), random.joints(1).cwiseAbs()};
  if (number % 3 == 0) box.half_widths = 0.1 * arm::JointVector::Unit(number % 6);
  const PlacedRobot placed = robot.at(box.centre);
  while (largestDisplacement(robot, placed, box.half_widths) > kBound) box.half_widths *= 0.97;
  return box;
}

Vector3d randomPointOf(RandomNumbers& random, const Capsule& capsule) {
  return capsule.from + random.within(0, 1) * (capsule.to - capsule.from) +
         capsule.radius * random.point(1).normalized();
}

/// How many points of the robot, at corners of the box and anywhere in it, the claim has not.
int pointsOutside(RandomNumbers& random, const RobotBodies& robot, const Box& box, const VoxelSet& claim) {
  int outside = 0;
  for (int i = 0; i < 200; ++i) {
    arm::JointVector part = random.joints(1);
    if (random.coin()) part = part.cwiseSign().eval();
    const PlacedRobot moved = robot.at(box.centre + box.half_widths.cwiseProduct(part));
    for (const Capsule& capsule : moved.capsules) {
      if (!claim.contains(voxelAt(randomPointOf(random, capsule), kEdge))) ++outside;
    }
  }
  return outside;
}

TEST(RobotClaim, hasEveryPointOfTheRobotAndWithHalfOfTheBoundHasNot) {
  RandomNumbers random(19);
  const RobotBodies robot = robotAt({100, 200, 300, 10, 20, 30});
  int outside_half = 0;
  for (int i = 0; i < 24; ++i) {
    const Box box = randomBox(random, robot, i);
    const PlacedRobot placed = robot.at(box.centre);
    VoxelSet claim;
    claimRobot(claim, robot, placed, box.half_widths, 0, kEdge);
    ASSERT_EQ(pointsOutside(random, robot, box, claim), 0) << i;
    VoxelSet half;
    for (std::size_t k = 0; k < placed.capsules.size(); ++k) {
      Capsule grown = placed.capsules[k];
      grown.radius += 0.5 * displacementBound(grown, robot.bodies()[k].link, placed.axes, box.half_widths);
      claimCapsule(half, grown, kEdge);
    }
    outside_half += pointsOutside(random, robot, box, half);
  }
  EXPECT_GT(outside_half, 0);
}

TEST(RobotClaim, hasNothingThatIsFartherThanItSays) {
  constexpr double kClearance = 0.012;
  RandomNumbers random(20);
  const RobotBodies robot = robotAt({100, 200, 300, 10, 20, 30});
  for (int i = 0; i < 6; ++i) {
    const Box box = randomBox(random, robot, i);
    const PlacedRobot placed = robot.at(box.centre);
    VoxelSet claim;
    claimRobot(claim, robot, placed, box.half_widths, kClearance, kEdge);
    const double farthest =
        largestDisplacement(robot, placed, box.half_widths) + kClearance + std::sqrt(3) * kEdge;
    for (const Voxel& voxel : claim.sorted()) {
      const Vector3d corner = cubeOf(voxel, kEdge).upper;
      double distance = std::numeric_limits<double>::infinity();
      for (const Capsule& body : placed.capsules) {
        distance = std::min(distance, distanceToSegment(corner, body.from, body.to) - body.radius);
      }
      ASSERT_LE(distance, farthest + 1e-9);
    }
  }
}

/// The sphere at the flange of oracle 21, while joint 1 turns from 0 to 90 degrees.
class Arc {
 public:
  static constexpr double kSphere = 0.050;
  static constexpr double kStepBound = 0.010;
  static constexpr double kHalfMargin = 0.010;
  static constexpr double kVoxel = 0.020;

  /// Bisected until the bound of the displacement is small enough.
  void claim(double from, double to) {
    arm::JointVector joints = start_;
    joints[0] = 0.5 * (from + to);
    const PlacedRobot placed = robot_.at(joints);
    const arm::JointVector widths = 0.5 * (to - from) * arm::JointVector::Unit(0);
    Capsule sphere = placed.capsules.back();
    const double moved = displacementBound(sphere, arm::kJointCount, placed.axes, widths);
    if (moved > kStepBound) {
      claim(from, joints[0]);
      claim(joints[0], to);
      return;
    }
    sphere.radius += moved + kHalfMargin + 1e-6;
    claimCapsule(claimed, sphere, kVoxel);
    ++pieces;
    farthest = std::max(farthest, 2 * moved + kHalfMargin + 1e-6 + std::sqrt(3) * kVoxel);
  }

  [[nodiscard]] Vector3d centreAt(double angle) const {
    arm::JointVector joints = start_;
    joints[0] = angle;
    return robot_.at(joints).capsules.back().from;
  }

  VoxelSet claimed;
  int pieces = 0;
  double farthest = 0;  ///< the error bound

 private:
  const RobotBodies robot_ = robotAt({0, 0, 0, 0, 0, 0}, {{SphereShape{kSphere}, arm::Pose::Identity()}});
  const arm::JointVector start_ = arm::toJointVector({0, 45, 60, -15, 90, 0});
};

TEST(RobotClaim, ofASphereOnAnArcIsATube) {
  Arc arc;
  const Vector3d start = arc.centreAt(0);
  const double radius = start.head<2>().norm();
  EXPECT_NEAR(radius, 0.81604, 1e-5);
  EXPECT_NEAR(start.z(), 0.2289, 1e-5);
  arc.claim(0, kPi / 2);
  EXPECT_GE(arc.pieces, 69);
  EXPECT_LE(arc.pieces, 128);

  RandomNumbers random(22);
  for (int i = 0; i < 20000; ++i) {
    const double length = (Arc::kSphere + Arc::kHalfMargin) * std::cbrt(random.within(0, 1));
    const Vector3d point = arc.centreAt(random.within(0, kPi / 2)) + length * random.point(1).normalized();
    ASSERT_TRUE(arc.claimed.contains(voxelAt(point, Arc::kVoxel)));
  }
  const double begin = std::atan2(start.y(), start.x());
  for (const Voxel& voxel : arc.claimed.sorted()) {
    const AlignedBox cube = cubeOf(voxel, Arc::kVoxel);
    for (const Vector3d& corner : {cube.lower, cube.upper}) {
      const double angle = std::clamp(std::atan2(corner.y(), corner.x()) - begin, 0.0, kPi / 2);
      ASSERT_LE((corner - arc.centreAt(angle)).norm() - Arc::kSphere, arc.farthest + 1e-9);
    }
  }
  EXPECT_GT(8e-3 * static_cast<double>(arc.claimed.count()), 15.4);
}

TEST(RobotClaim, growsWithWhatTheRobotCarries) {
  const RobotBodies robot = robotAt({0, 0, 0, 0, 0, 0});
  const Capsules sheet =
      *capsulesOf(Shape{BoxShape{{0.400, 0.300, 0.005}}, arm::toPose({0, 0, 125, 0, 0, 0})});
  const RobotBodies loaded = robot.carrying({{"sheet", sheet}});
  const arm::JointVector joints = arm::toJointVector({0, 45, 60, -15, 90, 0});
  VoxelSet without;
  VoxelSet with;
  claimRobot(without, robot, robot.at(joints), arm::JointVector::Zero(), 0.010, 0.020);
  claimRobot(with, loaded, loaded.at(joints), arm::JointVector::Zero(), 0.010, 0.020);
  EXPECT_TRUE((without - with).empty());
  const double litres = 8e-3 * static_cast<double>((with - without).count());
  EXPECT_GT(litres, 0.4 * 0.3 * 0.005 * 1e3);
}

}  // namespace
}  // namespace cobot_command::cell
