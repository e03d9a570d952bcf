// A target as a pose in a tf frame: what is refused, and where it lies for the controller.

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

template <class Change>
MoveAbsoluteGoal posed(const Change& change) {
  FramedPose pose = framedPose();
  change(pose);
  return with<MoveAbsoluteGoal>([&](auto& g) { g.target_pose = pose; });
}

void expectTarget(const MoveAbsoluteGoal& goal, const arm::Pose& base, const SixValues& expected) {
  ASSERT_EQ(errorOf(goal), 0);
  const auto ptp = std::get<script::Ptp>(commandOf(goal, base));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(ptp.target[i], expected[i], 1e-9) << i;
}

TEST(FramedPose, isTurnedIntoTheRobotBase) {
  expectTarget(posed([](auto&) {}), arm::Pose::Identity(), {800, 100, 300, 0, 0, 90});
}

TEST(FramedPose, isSeenFromTheActiveBase) {
  const arm::Pose base = arm::toPose({500, 100, -200, 0, 0, 90});
  expectTarget(posed([](auto&) {}), base, {0, -300, 500, 0, 0, 0});
}

TEST(FramedPose, makesTheActiveBaseNeeded) {
  EXPECT_TRUE(traitsOf(posed([](auto&) {})).needs_base);
  EXPECT_FALSE(traitsOf(good<MoveAbsoluteGoal>()).needs_base);
  for (auto pose : {&MoveCircleGoal::arc_pose, &MoveCircleGoal::end_pose}) {
    EXPECT_TRUE(traitsOf(with<MoveCircleGoal>([&](auto& g) { g.*pose = framedPose(); })).needs_base);
  }
}

TEST(FramedPose, standsInPlaceOfTheNumbers) {
  MoveAbsoluteGoal goal = posed([](auto&) {});
  goal.target[0] = kNan;
  EXPECT_EQ(errorOf(goal), 0);
}

TEST(FramedPose, isRefusedInAFrameThatNobodyKnows) {
  const MoveAbsoluteGoal goal = posed([](FramedPose& p) {
    p.frame = "shelf";
    p.frame_in_robot_base.reset();
    p.fault = "no such frame";
  });
  const auto failures = check(goal);
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].error_id, own_error::kFrameUnknown);
  EXPECT_EQ(failures[0].found, "target_pose is in \"shelf\": no such frame");
}

TEST(FramedPose, isRefusedInAFrameWhosePlaceIsNoNumber) {
  EXPECT_EQ(errorOf(posed([](FramedPose& p) { p.frame_in_robot_base->translation()[1] = kNan; })),
            own_error::kFrameUnknown);
}

TEST(FramedPose, isRefusedWhenANumberIsNotFinite) {
  for (const double bad : {kNan, kInf, -kInf}) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(errorOf(posed([&](FramedPose& p) { p.position[i] = bad; })), own_error::kNotFinite);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(errorOf(posed([&](FramedPose& p) { p.quaternion[i] = bad; })), own_error::kNotFinite);
    }
  }
}

TEST(FramedPose, isRefusedWhenTheQuaternionIsNotOfUnitLength) {
  const auto scaled = [](double length) {
    return errorOf(posed([&](FramedPose& p) { p.quaternion = {0, 0.6 * length, 0, 0.8 * length}; }));
  };
  for (const double length : {1.0, 0.9991, 1.0009}) EXPECT_EQ(scaled(length), 0) << length;
  for (const double length : {0.0, 1e-300, 0.9989, 1.0011, 1e200, 1e308}) {
    EXPECT_EQ(scaled(length), own_error::kQuaternion) << length;
  }
}

TEST(FramedPose, isSentWithItsQuaternionNormalised) {
  expectTarget(posed([](FramedPose& p) {
                 p.quaternion = {0, 0, 0, 0.9995};
               }),
               arm::Pose::Identity(), {800, 100, 300, 0, 0, 90});
}

TEST(FramedPose, isRefusedFurtherAwayThanAnyArmReaches) {
  const auto at = [](double x) { return errorOf(posed([&](FramedPose& p) { p.position = {x, 0, 0}; })); };
  EXPECT_EQ(at(100), 0);
  EXPECT_EQ(at(100.001), own_error::kCoordinateRange);
  EXPECT_EQ(at(1e308), own_error::kCoordinateRange);
  // Far from the origin of its own frame, but near the robot: a map.
  EXPECT_EQ(errorOf(posed([](FramedPose& p) {
              p.position = {500000, 0, 0};
              *p.frame_in_robot_base = arm::Pose::Identity();
              p.frame_in_robot_base->translation() << -499999.5, 0, 0;
            })),
            0);
}

TEST(FramedPose, givesBothPointsOfACircle) {
  const auto goal = with<MoveCircleGoal>([](auto& g) {
    g.arc_pose = framedPose();
    g.end_pose = framedPose();
    g.end_pose->position = {0, 0, 0};
    g.arc_point[0] = g.end_point[0] = kNan;
  });
  EXPECT_EQ(errorOf(goal), 0);
  EXPECT_THAT(scriptOf(goal), HasSubstr("Circle(\"CPP\",800,100,300,0,0,90,1000,0,0,0,0,90,"));
}

TEST(FramedPose, isNamedByItsFieldInACircle) {
  auto goal = good<MoveCircleGoal>();
  goal.arc_pose = framedPose();
  goal.end_pose = framedPose();
  goal.arc_pose->quaternion = {0, 0, 0, 0};
  goal.end_pose->frame_in_robot_base.reset();
  const auto failures = check(goal);
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_THAT(failures[0].found, HasSubstr("end_pose is in \"table\""));
  EXPECT_THAT(failures[1].found, HasSubstr("arc_pose has length 0"));
}

}  // namespace
}  // namespace cobot_command::testing
