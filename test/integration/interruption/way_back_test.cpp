// The way back to where the robot was interrupted.
#include "interrupted_robot.h"

#include "cobot_command/blocks/ways_back/return_to_primary.h"

namespace cobot_command::testing {
namespace {

using blocks::ReturnMode;
using blocks::ReturnToPrimaryGoal;
using blocks::ReturnTrajectory;
using ::testing::HasSubstr;

ReturnToPrimaryGoal wayBack(ReturnMode mode, ReturnTrajectory trajectory) {
  ReturnToPrimaryGoal goal;
  goal.return_mode = static_cast<int>(mode);
  goal.trajectory_mode = static_cast<int>(trajectory);
  goal.speed = 50;
  return goal;
}

class TheWayBack : public ::testing::Test {
 protected:
  /// Half way down, and then moved away.
  void SetUp() override {
    first = rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
    second = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 20, 0, 0, 0})));
    ASSERT_TRUE(rig.passUntilZ(420));
    rig.expectInterrupted();
    place = rig.jointsDeg();
    rig.moveTo({20, 5, 85, 0, 90, 10});
  }
  void expectRefused(const ReturnToPrimaryGoal& goal, int error_id, const std::string& words) {
    const blocks::Outcome& outcome = rig.endOf(rig.submit(goal));
    EXPECT_EQ(outcome.ending, Ending::Rejected);
    EXPECT_EQ(outcome.error_id, error_id) << outcome.error_description;
    EXPECT_THAT(outcome.error_description, HasSubstr(words));
  }
  void expectBothDone() {
    rig.expectGoesOn();
    rig.expectDone(first);
    rig.expectDone(second);
    EXPECT_NEAR(rig.place().z(), 381.05, 1e-2);
  }

  InterruptedRobot rig;
  GoalId first = 0;
  GoalId second = 0;
  std::array<double, 6> place{};
};

TEST_F(TheWayBack, leadsToWhereItWasInterruptedInALineOrInJoints) {
  for (const auto trajectory : {ReturnTrajectory::Linear, ReturnTrajectory::Ptp}) {
    const GoalId id = rig.submit(wayBack(ReturnMode::InterruptPosition, trajectory));
    rig.expectDone(id);
    rig.pass(200ms);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(rig.jointsDeg()[i], place[i], 0.01);
    EXPECT_TRUE(rig.group().in_primary_position);
    const auto& told = rig.progress(id);
    ASSERT_GT(told.size(), 3U);
    EXPECT_GT(*told[1].distance_mm, 50);
    EXPECT_LT(*told.back().distance_mm, *told[1].distance_mm);
    if (trajectory == ReturnTrajectory::Linear) rig.moveTo({20, 5, 85, 0, 90, 10});
  }
  expectBothDone();
}

TEST_F(TheWayBack, mayLeadToTheEndOfTheMotionThatWasInterrupted) {
  rig.expectDone(rig.submit(wayBack(ReturnMode::EndPosition, ReturnTrajectory::Ptp)));
  rig.pass(200ms);
  EXPECT_NEAR(rig.place().z(), 361.05, 0.05);
  EXPECT_EQ(rig.outcome(first), nullptr) << "its goal ends when it goes on";
  expectBothDone();
}

TEST_F(TheWayBack, isNotGoneFromTooFarAway) {
  auto goal = wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Linear);
  goal.distance_limit = 50;
  expectRefused(goal, 0x8C07, "mm away");
  goal.distance_limit = 500;
  rig.expectDone(rig.submit(goal));
}

TEST_F(TheWayBack, isNotGoneWithAnotherTool) {
  rig.expectDone(rig.submit(good<blocks::ChangeTcpGoal>()));
  rig.pass(500ms);
  auto goal = wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Ptp);
  expectRefused(goal, 0x8C22, "TCP");
  goal.allow_differences = true;
  rig.expectDone(rig.submit(goal));
  rig.pass(200ms);
  EXPECT_TRUE(rig.goOn().success) << "with the tool that it has now, as that was allowed";
}

TEST_F(TheWayBack, mayBeCancelledAndGoneOnceMore) {
  const GoalId id = rig.submit(wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Linear));
  rig.pass(300ms);
  rig.cancel(id);
  EXPECT_EQ(rig.endOf(id).ending, Ending::CommandAborted);
  EXPECT_EQ(rig.goOn().error_id, 0x8C02);
  rig.expectDone(rig.submit(wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Linear)));
  rig.pass(200ms);
  expectBothDone();
}

TEST(AWayBack, isNoneWhereNothingIsInterrupted) {
  InterruptedRobot rig;
  const blocks::Outcome& outcome =
      rig.endOf(rig.submit(wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Ptp)));
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, 0x233);
}

TEST(AWayBack, leadsToAPathToo) {
  InterruptedRobot rig;
  blocks::LoadPathGoal goal;
  for (const double angle : {20.0, 40.0}) goal.path.push_back(pathPoint({angle, 0, 90, 0, 90, 0}));
  goal.number_of_moves = 2;
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntil([&] { return rig.jointDeg(0) > 30; }, 1min));
  rig.expectInterrupted();
  rig.moveTo({0, 20, 80, 0, 90, 0});
  rig.expectDone(rig.submit(wayBack(ReturnMode::InterruptPosition, ReturnTrajectory::Ptp)));
  rig.pass(200ms);
  rig.expectGoesOn();
  rig.expectDone(id);
  EXPECT_NEAR(rig.jointDeg(0), 40, 1e-2);
}

}  // namespace
}  // namespace cobot_command::testing
