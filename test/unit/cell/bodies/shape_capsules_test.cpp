#include "cobot_command/cell/bodies/shape_capsules.h"

#include <limits>

#include "cell_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool contains(const Capsules& capsules, const Vector3d& point) {
  return std::any_of(capsules.begin(), capsules.end(), [&](const Capsule& capsule) {
    return distanceToSegment(point, capsule.from, capsule.to) <= capsule.radius + 1e-12;
  });
}

Shape boxOf(const Vector3d& size) {
  return {BoxShape{size}, arm::Pose::Identity()};
}

TEST(ShapeCapsules, ofACylinderAreOneAroundItsWholeAxis) {
  Shape shape{CylinderShape{0.05, 0.4}, arm::Pose::Identity()};
  shape.at.translation() = Vector3d(1, 2, 3);
  const auto capsules = capsulesOf(shape);
  ASSERT_TRUE(capsules);
  ASSERT_EQ(capsules->size(), 1u);
  EXPECT_EQ(capsules->front().from, Vector3d(1, 2, 2.8));
  EXPECT_EQ(capsules->front().to, Vector3d(1, 2, 3.2));
  EXPECT_EQ(capsules->front().radius, 0.05);
}

TEST(ShapeCapsules, ofASphereAndOfACapsuleAreThemselves) {
  const auto sphere = capsulesOf(Shape{SphereShape{0.05}, arm::Pose::Identity()});
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->front().from, sphere->front().to);
  EXPECT_EQ(sphere->front().radius, 0.05);
  const auto capsules = capsulesOf(gripper());
  ASSERT_TRUE(capsules);
  EXPECT_EQ(capsules->front().to, Vector3d(0, 0, 0.120));
}

TEST(ShapeCapsules, ofASheetAreSixAlongItsLongestEdge) {
  const auto capsules = capsulesOf(boxOf({0.400, 0.300, 0.005}));
  ASSERT_TRUE(capsules);
  EXPECT_EQ(capsules->size(), 6u);  // five would have a radius of 30.1 mm
  for (const Capsule& capsule : *capsules) {
    EXPECT_DOUBLE_EQ(capsule.to.x() - capsule.from.x(), 0.400);
    EXPECT_DOUBLE_EQ(capsule.radius, 0.5 * std::hypot(0.050, 0.005));
  }
}

TEST(ShapeCapsules, ofABoxAreTheFewestThatAreThinEnough) {
  RandomNumbers random(5);
  for (int i = 0; i < 500; ++i) {
    const Vector3d size(random.within(0, 0.5), random.within(0, 0.5), random.within(0.5, 0.6));
    const double body_cell = random.within(0.01, 0.2);
    const auto capsules = capsulesOf(boxOf(size), body_cell);
    ASSERT_TRUE(capsules);
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t across = 1; across < 60; ++across) {
      for (std::size_t up = 1; up < 60; ++up) {
        const double radius =
            0.5 * std::hypot(size.x() / static_cast<double>(across), size.y() / static_cast<double>(up));
        if (radius <= body_cell) fewest = std::min(fewest, across * up);
      }
    }
    EXPECT_EQ(capsules->size(), fewest);
    EXPECT_LE(capsules->front().radius, body_cell + 1e-12);
  }
}

TEST(ShapeCapsules, containTheWholeBox) {
  RandomNumbers random(6);
  for (int i = 0; i < 300; ++i) {
    Shape shape = boxOf(random.point(0.3).cwiseAbs());
    shape.at = random.pose(1);
    const auto capsules = capsulesOf(shape);
    ASSERT_TRUE(capsules);
    const Vector3d half = 0.5 * std::get<BoxShape>(shape.kind).size;
    for (int k = 0; k < 100; ++k) {
      const Vector3d part = random.point(1);
      const bool corner = k < 20;
      ASSERT_TRUE(contains(*capsules, shape.at * half.cwiseProduct(corner ? part.cwiseSign().eval() : part)));
    }
  }
}

TEST(ShapeCapsules, areRefusedWhereALengthIsNone) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(capsulesOf(boxOf({0.1, -0.1, 0.1})));
  EXPECT_FALSE(capsulesOf(boxOf({0.1, kNotANumber, 0.1})));
  EXPECT_FALSE(capsulesOf(boxOf({0, 0, 0})));
  EXPECT_FALSE(capsulesOf(boxOf({infinite, 1, 1})));
  EXPECT_FALSE(capsulesOf(Shape{SphereShape{0}, arm::Pose::Identity()}));
  EXPECT_FALSE(capsulesOf(Shape{SphereShape{kNotANumber}, arm::Pose::Identity()}));
  EXPECT_FALSE(capsulesOf(Shape{CylinderShape{0.1, -1}, arm::Pose::Identity()}));
  EXPECT_FALSE(capsulesOf(Shape{CylinderShape{0, 1}, arm::Pose::Identity()}));
  EXPECT_FALSE(capsulesOf(Shape{CapsuleShape{{0, 0, 0}, {0, 0, infinite}, 0.1}, arm::Pose::Identity()}));
  EXPECT_FALSE(capsulesOf(Shape{CapsuleShape{{0, 0, 0}, {0, 0, 1}, -0.1}, arm::Pose::Identity()}));
}

TEST(ShapeCapsules, areRefusedWhereABoxNeedsTooMany) {
  for (const double size : {10.0, 1e9, 1e300}) {
    const auto capsules = capsulesOf(boxOf({size, size, size}), 0.005);
    ASSERT_FALSE(capsules);
    EXPECT_THAT(capsules.error().message, HasSubstr("body_cell"));
  }
}

TEST(ShapeCapsules, allowBoxesWithoutThickness) {
  const auto plate = capsulesOf(boxOf({0.1, 0.05, 0}));
  ASSERT_TRUE(plate);
  EXPECT_EQ(plate->size(), 1u);
  EXPECT_DOUBLE_EQ(plate->front().radius, 0.025);
  const auto wire = capsulesOf(boxOf({0.1, 0, 0}));
  ASSERT_TRUE(wire);
  EXPECT_EQ(wire->front().radius, 0);
}

}  // namespace
}  // namespace cobot_command::cell
