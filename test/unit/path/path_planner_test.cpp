// Whole paths: their times, where the arm is, and that cutting them into goals changes nothing.
#include "path_support.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

/// Ten short lines around a corner, all blended.
std::vector<PathPoint> tenPoints(const arm::ControllerPose& from) {
  std::vector<PathPoint> points;
  arm::ControllerPose pose = from;
  for (int i = 0; i < 10; ++i) {
    pose[i < 5 ? 1 : 2] += 20;
    points.push_back(blending(toPose(pose), 3));
  }
  return points;
}

/// A quarter of a turn of J1, 1.5 s.
PathPoint quarterTurn() {
  PathPoint point = toJoints({90, 0, 90, 0, 90, 0});
  point.speed = 90;
  point.acceleration = point.deceleration = 180;
  return point;
}

TEST_F(Paths, takeTheTimeOfTheirMoves) {
  EXPECT_NEAR(toSeconds(planned({quarterTurn()}).duration()), 1.5, kGrid);
}

TEST_F(Paths, runAsTheFeedrateSays) {
  scene.feedrate = 0.5;
  const PathPlan slow = planned({quarterTurn()});
  EXPECT_NEAR(toSeconds(slow.duration()), 3.0, kGrid);
  EXPECT_NEAR(radToDeg(slow.at(milliseconds(1500)).velocity[0]), 45.0, 0.1);
  EXPECT_NEAR(radToDeg(slow.at(milliseconds(500)).velocity[0]), 22.5, 0.1);
  scene.feedrate = 1.25;
  EXPECT_NEAR(toSeconds(planned({quarterTurn()}).duration()), 1.2, kGrid);
}

/// What was planned at one feedrate and is planned again at another one is as if it had been planned so.
TEST_F(Paths, canBePlannedAgainAtAnotherFeedrate) {
  std::vector<PathPoint> points = tenPoints(flangeAt(scene.start));
  points.push_back(blending(quarterTurn(), 50));
  PathPlanner before(scene);
  ASSERT_FALSE(before.append(sectionOf(points)));
  scene.feedrate = 0.4;
  PathPlanner again(scene);
  ASSERT_FALSE(again.appendAgain(before.plan().points(), before));
  PathPlanner wanted(scene);
  ASSERT_FALSE(wanted.append(sectionOf(points)));
  const PathPoint increment = incremental(toPose({0, 0, -10, 0, 0, 0}));
  points = {increment};
  points[0].speed = 50;
  for (PathPlanner* planner : {&again, &wanted}) ASSERT_FALSE(planner->append(sectionOf(points)));
  ASSERT_EQ(again.plan().duration(), wanted.plan().duration());
  for (Duration time{}; time <= wanted.plan().duration(); time += milliseconds(5)) {
    ASSERT_EQ(again.plan().at(time).position, wanted.plan().at(time).position) << toSeconds(time);
  }
}

TEST_F(Paths, keepTheDynamicsOfTheirKindWhereAPointSaysNone) {
  const PathPoint line = incremental(toPose({0, 0, -100, 0, 0, 0}));
  PathPoint back = toJoints({0, 0, 90, 0, 90, 0});
  PathPoint again = quarterTurn();
  for (PathPoint* point : {&back, &again}) point->speed = point->acceleration = point->deceleration = 0;
  const PathPlan plan = planned({quarterTurn(), line, back, again});
  EXPECT_EQ(plan.points()[3].motion->duration(), plan.points()[0].motion->duration());
}

TEST_F(Paths, areTheSameInOneGoalAndInSeveral) {
  const std::vector<PathPoint> points = tenPoints(flangeAt(scene.start));
  const PathPlan whole = planned(points);
  for (const int size : {5, 1}) {
    PathPlanner planner(scene);
    for (int first = 0; first < 10; first += size) {
      PathSection section = sectionOf(points);
      section.start_index = first;
      section.number_of_moves = size;
      ASSERT_FALSE(planner.append(section));
    }
    ASSERT_EQ(planner.plan().duration(), whole.duration());
    for (Duration time{}; time <= whole.duration(); time += milliseconds(1)) {
      const motion::JointState a = whole.at(time);
      const motion::JointState b = planner.plan().at(time);
      ASSERT_EQ(a.position, b.position) << toSeconds(time);
      ASSERT_EQ(a.velocity, b.velocity) << toSeconds(time);
    }
  }
}

TEST_F(Paths, areContinuousInPlaceAndSpeed) {
  const PathPlan plan = planned(tenPoints(flangeAt(scene.start)));
  const Duration step = std::chrono::microseconds(100);
  motion::JointState previous = plan.at(Duration::zero());
  for (Duration time = step; time <= plan.duration(); time += step) {
    const motion::JointState state = plan.at(time);
    const arm::JointVector moved = state.position - previous.position;
    const arm::JointVector mean = 0.5 * (state.velocity + previous.velocity) * toSeconds(step);
    ASSERT_LT((moved - mean).cwiseAbs().maxCoeff(), 1e-8) << toSeconds(time);
    ASSERT_LT((state.velocity - previous.velocity).cwiseAbs().maxCoeff(), 1e-2) << toSeconds(time);
    previous = state;
  }
}

TEST_F(Paths, tellWhichPointMovesTheArmAndHowFarItIs) {
  const PathPlan plan = planned(tenPoints(flangeAt(scene.start)));
  const PathPlan::Place before = plan.placeAt(plan.points()[1].start);
  EXPECT_EQ(before.point, 0U);
  EXPECT_TRUE(before.blends);
  EXPECT_EQ(before.next_share, 0.0);
  const PathPlan::Place alone = plan.placeAt(plan.points()[0].end());
  EXPECT_EQ(alone.point, 1U);
  EXPECT_FALSE(alone.blends);
  EXPECT_GT(alone.share, 0.0);
  const PathPlan::Place last = plan.placeAt(plan.duration());
  EXPECT_EQ(last.point, 9U);
  EXPECT_EQ(last.share, 1.0);
}

TEST_F(Paths, toWhereTheArmIsTakeNoTimeAndBlendWithNothing) {
  const PathPoint there = blending(toJoints({30, 0, 90, 0, 90, 0}), 50);
  const PathPlan plan = planned({there, there, toJoints({60, 0, 90, 0, 90, 0})});
  EXPECT_EQ(plan.points()[1].motion->duration(), Duration::zero());
  EXPECT_EQ(plan.points()[0].overlap, Duration::zero());
  EXPECT_EQ(plan.points()[1].overlap, Duration::zero());
  EXPECT_TRUE(plan.points()[1].losesBlend());
}

TEST_F(Paths, thatAreRefusedLeaveThePlannerAsItWas) {
  PathPlanner planner(scene);
  ASSERT_FALSE(planner.append(sectionOf({toJoints({30, 0, 90, 0, 90, 0})})));
  const Duration before = planner.plan().duration();
  EXPECT_TRUE(planner.append(sectionOf({toJoints({40, 0, 90, 0, 90, 0}), toJoints({0, 0, 170, 0, 90, 0})})));
  EXPECT_EQ(planner.plan().duration(), before);
  EXPECT_EQ(planner.plan().points().size(), 1U);
}

TEST_F(Paths, lookAtNoPointOutsideTheirSection) {
  std::vector<PathPoint> points(20);
  for (std::size_t i = 5; i < 15; ++i) points[i] = toJoints({static_cast<double>(i), 0, 90, 0, 90, 0});
  PathSection section = sectionOf(points);
  section.start_index = 5;
  section.number_of_moves = 10;
  PathPlanner planner(scene);
  ASSERT_FALSE(planner.append(section));
  EXPECT_EQ(planner.plan().points().front().index, 5);
  EXPECT_EQ(planner.plan().points().back().index, 14);
}

}  // namespace
}  // namespace cobot_command::path
