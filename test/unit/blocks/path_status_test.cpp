// What a chain tells everyone of how its path goes, and when.
#include "block_goals.h"
#include "paths/path_status_report.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::blocks {
namespace {

using std::chrono::milliseconds;

constexpr Instant kBegin{};

TEST(PathStatusClockTest, isDueTwentyTimesASecondFromItsBegin) {
  PathStatusClock clock;
  EXPECT_FALSE(clock.takeDue(kBegin));
  clock.begin(kBegin);
  clock.begin(kBegin + milliseconds(20));
  int told = 0;
  for (int time = 0; time < 1000; time += 15) told += clock.takeDue(kBegin + milliseconds(time)) ? 1 : 0;
  EXPECT_EQ(told, 20);
  EXPECT_TRUE(clock.end());
  EXPECT_FALSE(clock.end());
  EXPECT_EQ(clock.due(), std::nullopt);
}

TEST(PathStatusClockTest, doesNotMakeUpForWhatItWasLate) {
  PathStatusClock clock;
  clock.begin(kBegin);
  EXPECT_TRUE(clock.takeDue(kBegin + milliseconds(500)));
  EXPECT_FALSE(clock.takeDue(kBegin + milliseconds(549)));
  EXPECT_TRUE(clock.takeDue(kBegin + milliseconds(550)));
}

class PathStatusTest : public ::testing::Test {
 protected:
  /// Two turns of the base, blended, with the numbers 11 and 12.
  static PathReport planned() {
    LoadPathGoal goal;
    goal.path = {testing::pathPoint({40, 0, 90, 0, 90, 0}), testing::pathPoint({80, 0, 90, 0, 90, 0})};
    goal.path[0].termination_type = static_cast<int>(path::Termination::Blend);
    goal.path[0].command_tolerance = 30;
    goal.path[0].move_id = 11;
    goal.path[1].move_id = 12;
    goal.path[0].ref_frame_id = 5;
    goal.number_of_moves = 2;
    PlanningScene scene;
    scene.arm = &arm();
    scene.start.emplace();
    scene.start->joints = arm::toJointVector({0, 0, 90, 0, 90, 0});
    return plan(goal, scene).detail.as<PathReport>();
  }
  static const arm::ArmModel& arm() {
    static const arm::ArmModel model = *arm::ArmModel::named("tm5-900");
    return model;
  }

  PathStatusTest() : chain(1, planned()), progress(arm()), plan_(chain.members().front().loaded->plan) {
    chain.sendNext();
  }
  void begin(double rate) { progress.begin(chain.sent().front(), rate, kBegin); }
  [[nodiscard]] PathStatus at(Duration time) {
    const PathChain::Place place = progress.placeAt(kBegin + time);
    return statusOf(chain, place, progress, kBegin + time);
  }

  PathChain chain;
  PathProgress progress;
  path::PathPlan plan_;
};

TEST_F(PathStatusTest, isOfThePointThatMovesTheRobot) {
  begin(1.0);
  const PathStatus status = at(plan_.points()[1].start / 2);
  EXPECT_TRUE(status.path_planner_active);
  EXPECT_EQ(status.active_move_id, 11);
  EXPECT_EQ(status.active_interpolation, static_cast<int>(path::Interpolation::Ptp));
  EXPECT_EQ(status.active_type, static_cast<int>(path::MovedFrame::Flange));
  EXPECT_EQ(status.active_ref_frame_type, static_cast<int>(path::Reference::Robot));
  EXPECT_EQ(status.active_ref_frame_id, 5);
  EXPECT_GT(status.active_move_percent, 5);
  EXPECT_LT(status.active_move_percent, 95);
  EXPECT_EQ(status.blending_move_id, 0);
  EXPECT_EQ(status.blending_move_percent, 0);
  EXPECT_EQ(status.source, ProgressSource::Plan);
  EXPECT_EQ(status.feedrate, 100);
  EXPECT_EQ(status.feedrate_effective, 100);
  EXPECT_FALSE(status.gate_waits);
}

TEST_F(PathStatusTest, isOfTheOutgoingPointWhileTwoBlend) {
  begin(1.0);
  const Duration overlap = plan_.points()[0].overlap;
  ASSERT_GT(overlap, Duration::zero());
  const PathStatus blends = at(plan_.points()[1].start + overlap / 2);
  EXPECT_EQ(blends.active_move_id, 11);
  EXPECT_EQ(blends.blending_move_id, 12);
  EXPECT_GT(blends.active_move_percent, 70);
  EXPECT_GT(blends.blending_move_percent, 0);
  EXPECT_LT(blends.blending_move_percent, 30);
  const PathStatus alone = at(plan_.points()[0].end() + milliseconds(1));
  EXPECT_EQ(alone.active_move_id, 12);
  EXPECT_EQ(alone.blending_move_id, 0);
}

TEST_F(PathStatusTest, hasTheSpeedsOfThePlanAtTheRateThatItRuns) {
  const Duration ramp = milliseconds(50);
  begin(1.0);
  const PathStatus whole = at(ramp);
  begin(0.5);
  const PathStatus half = at(2 * ramp);
  EXPECT_GT(whole.angular_velocity, 1);
  EXPECT_GT(whole.linear_velocity, 1);
  EXPECT_NEAR(half.angular_velocity, whole.angular_velocity / 2, 1e-6);
  EXPECT_NEAR(half.linear_velocity, whole.linear_velocity / 2, 1e-6);
  EXPECT_NEAR(half.linear_acceleration, whole.linear_acceleration / 4, 1e-4);
  EXPECT_NEAR(half.angular_acceleration, whole.angular_acceleration / 4, 1e-4);
}

TEST_F(PathStatusTest, hasNoSpeedWhileTheRobotIsHeld) {
  begin(1.0);
  progress.hold(true, kBegin + milliseconds(200));
  const PathStatus held = at(milliseconds(400));
  EXPECT_EQ(held.linear_velocity, 0);
  EXPECT_EQ(held.active_move_id, 11);
}

TEST_F(PathStatusTest, isOfNoPointWhileNoPieceIsUnderWay) {
  const PathStatus status = statusOf(chain, {0, 0}, progress, kBegin);
  EXPECT_TRUE(status.path_planner_active);
  EXPECT_EQ(status.active_move_id, 0);
  EXPECT_EQ(status.linear_velocity, 0);
}

}  // namespace
}  // namespace cobot_command::blocks
