#include "preview/trail.h"

#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::SizeIs;

Eigen::Vector3d at(double x) {
  return {x, 0, 0};
}

TEST(Trail, hasThePlacesThatTheToolWasAtWhileTheRobotMoved) {
  Trail trail;
  EXPECT_FALSE(trail.add(at(0), false, 0));
  EXPECT_TRUE(trail.add(at(0.1), true, 1));
  EXPECT_TRUE(trail.add(at(0.2), true, 1.1));
  EXPECT_FALSE(trail.add(at(0.3), false, 1.2));
  EXPECT_THAT(trail.places(), SizeIs(2));
}

TEST(Trail, leavesOutWhatCannotBeToldApart) {
  Trail trail;
  EXPECT_TRUE(trail.add(at(0.1), true, 1));
  EXPECT_FALSE(trail.add(at(0.1005), true, 1.1));
  EXPECT_TRUE(trail.add(at(0.102), true, 1.2));
}

TEST(Trail, goesOnBehindAShortRest) {
  Trail trail;
  trail.add(at(0.1), true, 1);
  trail.add(at(0.2), true, 1.9);
  EXPECT_THAT(trail.places(), SizeIs(2));
}

TEST(Trail, beginsAnewWithAMotionBehindARest) {
  Trail trail;
  trail.add(at(0.1), true, 1);
  trail.add(at(0.2), true, 1.1);
  trail.add(at(0.2), false, 2);
  EXPECT_THAT(trail.places(), SizeIs(2)) << "it is there to be looked at";
  EXPECT_TRUE(trail.add(at(0.5), true, 3));
  EXPECT_THAT(trail.places(), SizeIs(1));
}

TEST(Trail, isOfABoundedLength) {
  Trail trail;
  for (int i = 0; i < 7000; ++i) trail.add(at(0.01 * i), true, 0.01 * i);
  EXPECT_THAT(trail.places(), SizeIs(5000));
  EXPECT_DOUBLE_EQ(trail.places().back().x(), 69.99);
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
