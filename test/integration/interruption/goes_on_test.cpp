// What is interrupted goes on by the way that it would have gone, and ends as it would have ended.
#include "interrupted_robot.h"

#include "cobot_command/blocks/load_path.h"

namespace cobot_command::testing {
namespace {

using command::GroupState;
using ::testing::HasSubstr;

class WhatIsInterrupted : public ::testing::Test {
 protected:
  /// The goal `id` is interrupted when `reached`, goes on, and is done.
  void interruptAndGoOn(GoalId id, const std::function<bool()>& reached) {
    ASSERT_TRUE(rig.passUntil(reached, 1min)) << (rig.outcome(id) ? rig.endOf(id).error_description : "");
    rig.expectInterrupted();
    EXPECT_EQ(rig.outcome(id), nullptr);
    rig.pass(2s);
    EXPECT_EQ(rig.outcome(id), nullptr);
    rig.expectGoesOn();
    rig.expectDone(id);
  }

  InterruptedRobot rig;
};

TEST_F(WhatIsInterrupted, isALineThatGoesOnToItsTarget) {
  const GoalId id = rig.submit(lineTo({517.5, -122.3, 261.05, 180, 0, 90}));
  ASSERT_TRUE(rig.passUntilZ(400));
  rig.expectInterrupted();
  const double stopped = rig.place().z();
  EXPECT_GT(stopped, 300);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Interrupted);
  EXPECT_TRUE(rig.group().in_primary_position);
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("continue"));
  EXPECT_EQ(rig.status().commands_waiting, 1);
  rig.pass(3s);
  EXPECT_NEAR(rig.place().z(), stopped, 1e-6) << "nothing goes on by itself";
  rig.expectGoesOn();
  for (const auto& place : rig.wayUntilTheEndOf(id)) {
    EXPECT_NEAR(place.x(), 517.5, 0.05);
    EXPECT_NEAR(place.y(), -122.3, 0.05);
    EXPECT_LT(place.z(), stopped + 1e-3);
  }
  rig.expectDone(id);
  EXPECT_NEAR(rig.place().z(), 261.05, 1e-3);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
}

TEST_F(WhatIsInterrupted, isAnOffsetThatEndsWhereItWouldHaveEnded) {
  const GoalId base = rig.submit(lineBy({0, 0, -100, 0, 0, 30}));
  interruptAndGoOn(base, [&] { return rig.place().z() < 420; });
  EXPECT_NEAR(rig.pose()[2], 361.05, 1e-2);
  EXPECT_NEAR(rig.pose()[5], 120, 1e-2);
  const GoalId tool = rig.submit(lineBy({0, 50, 60, 0, 0, 0}, blocks::RelativeFormat::Tap));
  interruptAndGoOn(tool, [&] { return rig.place().z() < 330; });
  EXPECT_NEAR(rig.pose()[2], 301.05, 1e-2);
}

TEST_F(WhatIsInterrupted, isAMoveOfJoints) {
  const GoalId id = rig.submit(moveJoints({60, 10, 80, 0, 90, 0}, 20));
  interruptAndGoOn(id, [&] { return rig.jointDeg(0) > 30; });
  EXPECT_NEAR(rig.jointDeg(0), 60, 1e-3);
  EXPECT_NEAR(rig.jointDeg(1), 10, 1e-3);
}

TEST_F(WhatIsInterrupted, isAnArcThatStaysOnItsCircle) {
  auto goal = good<blocks::MoveCircleGoal>();
  goal.data_format = static_cast<int>(blocks::CircleFormat::Cap);
  goal.speed = 100;
  goal.arc_point = {417.5, -22.3, 461.05, 180, 0, 90};
  goal.end_point = {517.5, 77.7, 461.05, 180, 0, 90};
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntil([&] { return rig.place().y() > -60; }, 1min));
  rig.expectInterrupted();
  rig.expectGoesOn();
  for (const auto& place : rig.wayUntilTheEndOf(id)) {
    EXPECT_NEAR((place - Eigen::Vector3d(517.5, -22.3, 461.05)).norm(), 100, 0.1);
  }
  rig.expectDone(id);
  EXPECT_NEAR(rig.place().y(), 77.7, 1e-2);
}

TEST_F(WhatIsInterrupted, mayBeInterruptedAgain) {
  const GoalId id = rig.submit(lineTo({517.5, -122.3, 261.05, 180, 0, 90}));
  for (const double z : {430.0, 380.0, 330.0, 280.0}) {
    ASSERT_TRUE(rig.passUntilZ(z));
    rig.expectInterrupted();
    rig.expectGoesOn();
  }
  rig.expectDone(id);
  EXPECT_NEAR(rig.place().z(), 261.05, 1e-3);
}

TEST_F(WhatIsInterrupted, keepsWhatWaitsBehindItInItsOrder) {
  const GoalId first = rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  const GoalId second = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, -50, 0, 0, 0})));
  const GoalId third = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 20, 0, 0, 0})));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  EXPECT_EQ(rig.status().commands_waiting, 3);
  EXPECT_THAT(rig.progress(third).back().text, HasSubstr("interrupted"));
  const GoalId fourth = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 5, 0, 0, 0})));
  rig.pass(1s);
  EXPECT_FALSE(rig.accepted(fourth)) << "it waits behind the others";
  rig.expectGoesOn();
  for (const GoalId id : {first, second, third, fourth}) rig.expectDone(id);
  EXPECT_NEAR(rig.place().z(), 361.05 - 50 + 20 + 5, 1e-2);
}

/// Their goals have ended with their acceptance: nothing of their way is lost all the same.
TEST_F(WhatIsInterrupted, mayBeABlendedChain) {
  const blocks::SixValues corner = {517.5, -122.3, 361.05, 180, 0, 90};
  const blocks::SixValues side = {517.5, -22.3, 361.05, 180, 0, 90};
  const GoalId first = rig.submit(blended(30, lineTo(corner)));
  const GoalId second = rig.submit(inMode(BufferMode::Buffered, blended(30, lineTo(side))));
  const GoalId third = rig.submit(inMode(BufferMode::Buffered, lineTo({517.5, -22.3, 411.05, 180, 0, 90})));
  rig.expectDone(first);
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  EXPECT_EQ(rig.outcome(third), nullptr);
  rig.pass(1s);
  rig.expectGoesOn();
  double lowest = 1000;
  double least_y = 1000;
  for (const auto& place : rig.wayUntilTheEndOf(third)) {
    lowest = std::min(lowest, place.z());
    least_y = std::min(least_y, place.y());
    EXPECT_NEAR(place.x(), 517.5, 0.05);
  }
  rig.expectDone(second);
  rig.expectDone(third);
  EXPECT_LT(lowest, 376) << "by the corner";
  EXPECT_NEAR(least_y, -122.3, 0.05);
  EXPECT_NEAR(rig.place().z(), 411.05, 1e-2);
  EXPECT_NEAR(rig.place().y(), -22.3, 1e-2);
}

TEST_F(WhatIsInterrupted, mayBeABlendedMotionWithNothingBehindIt) {
  const GoalId id = rig.submit(blended(30, lineTo({517.5, -122.3, 361.05, 180, 0, 90})));
  rig.expectDone(id);
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  EXPECT_GT(rig.place().z(), 390);
  rig.expectGoesOn();
  ASSERT_TRUE(rig.passUntil([&] { return rig.place().z() < 361.06 && rig.stands(); }, 1min));
}

TEST_F(WhatIsInterrupted, isAPlaceInACycleAndItsDwellWaitsToo) {
  auto goal = good<blocks::PickAndPlaceGoal>();
  goal.steps[0].move = lineTo({517.5, -122.3, 361.05, 180, 0, 90});
  goal.steps[0].output.reset();
  goal.steps[0].dwell = 2;
  goal.steps.push_back({moveJoints({20, 0, 90, 0, 90, 0}), std::nullopt, std::nullopt, 0});
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.expectGoesOn();
  ASSERT_TRUE(rig.passUntil([&] { return rig.progress(id).back().phase == blocks::Phase::Dwelling; }, 1min));
  rig.pass(500ms);
  rig.expectInterrupted();
  rig.pass(10s);
  rig.expectGoesOn();
  rig.pass(1s);
  EXPECT_EQ(rig.progress(id).back().phase, blocks::Phase::Dwelling) << "1.5 s are left";
  rig.expectDone(id);
  EXPECT_NEAR(rig.jointDeg(0), 20, 1e-3);
}

TEST_F(WhatIsInterrupted, isAWaitForAnInputThatGetsItsTimeBack) {
  const GoalId id = rig.submit(good<blocks::WaitForInputGoal>());  // 10 s
  rig.pass(2s);
  rig.expectInterrupted();
  rig.pass(20s);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.expectGoesOn();
  rig.pass(7s);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.operate(simulator::SetInput{script::IoModule::ControlBox, 3, true});
  rig.expectDone(id);
}

TEST_F(WhatIsInterrupted, isAWaitForATimeThatStandsStillMeanwhile) {
  const GoalId id = rig.submit(good<blocks::WaitTimeGoal>());  // 10 s
  const GoalId behind = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, -50, 0, 0, 0})));
  rig.pass(2s);
  rig.expectInterrupted();
  EXPECT_EQ(rig.progress(id).back().phase, blocks::Phase::Held);
  EXPECT_NEAR(toSeconds(rig.progress(id).back().remaining.value_or(0s)), 8, 0.2);
  rig.pass(20s);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.expectGoesOn();
  EXPECT_EQ(rig.progress(id).back().phase, blocks::Phase::Active);
  EXPECT_NEAR(toSeconds(rig.progress(id).back().remaining.value_or(0s)), 8, 0.2);
  rig.pass(7s);
  EXPECT_EQ(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(behind), nullptr);
  rig.expectDone(id);
  rig.expectDone(behind);
}

/// Its time begins at the end of what is left of the motion, and what comes behind it begins there.
TEST_F(WhatIsInterrupted, isABlendedMotionThatATimeWaitsFor) {
  rig.submit(blended(30, lineTo({517.5, -122.3, 361.05, 180, 0, 90})));
  auto wait = good<blocks::WaitTimeGoal>();
  wait.time = 0.5;
  const GoalId id = rig.submit(inMode(BufferMode::Buffered, wait));
  const GoalId behind = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 50, 0, 0, 0, 0})));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  EXPECT_FALSE(rig.accepted(id));
  rig.pass(1s);
  rig.expectGoesOn();
  ASSERT_TRUE(rig.passUntil([&] { return rig.accepted(id); }, 1min));
  EXPECT_TRUE(rig.stands());
  EXPECT_NEAR(rig.place().z(), 361.05, 0.05);
  rig.expectDone(id);
  EXPECT_NEAR(rig.place().y(), -122.3, 0.05);
  rig.expectDone(behind);
}

TEST_F(WhatIsInterrupted, isAPathByEitherWayOfLoading) {
  for (const auto execution : {blocks::Execution::Pvt, blocks::Execution::Script}) {
    SCOPED_TRACE(toString(execution));
    blocks::LoadPathGoal goal;
    for (const double angle : {20.0, 40.0, 60.0}) {
      path::PathPoint point = pathPoint({angle, 0, 90, 0, 90, 0});
      point.speed = 36;  // a whole fifth of the rated speed: a script can say that
      goal.path.push_back(point);
    }
    goal.number_of_moves = 3;
    goal.execution = static_cast<int>(execution);
    const GoalId id = rig.submit(goal);
    interruptAndGoOn(id, [&] { return rig.jointDeg(0) > 30; });
    EXPECT_NEAR(rig.jointDeg(0), 60, 1e-2);
    rig.moveTo({0, 0, 90, 0, 90, 0});
  }
}

TEST_F(WhatIsInterrupted, isAScriptOfMotions) {
  blocks::RunScriptGoal goal;
  goal.script = R"(Line("CAP",517.5,-122.3,361.05,180,0,90,100,200,0,false))"
                "\r\n"
                R"(IO["ControlBox"].DO[2]=1)"
                "\r\n"
                R"(Line("CAP",517.5,-122.3,411.05,180,0,90,100,200,0,false))";
  goal.await_motion = true;
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntilZ(365));
  ASSERT_TRUE(rig.passUntil([&] { return rig.place().z() > 375; }, 10s)) << "on its way back";
  rig.expectInterrupted();
  rig.expectGoesOn();
  for (const auto& place : rig.wayUntilTheEndOf(id)) EXPECT_GT(place.z(), 374) << "not down again";
  rig.expectDone(id);
}

TEST_F(WhatIsInterrupted, goesOnAtTheSpeedThatIsSetByThen) {
  const GoalId id = rig.submit(lineTo({517.5, -122.3, 261.05, 180, 0, 90}));
  ASSERT_TRUE(rig.passUntilZ(420));
  rig.expectInterrupted();
  rig.setSpeedOverride(50);
  rig.expectGoesOn();
  rig.pass(1s);
  const double before = rig.place().z();
  rig.pass(500ms);
  EXPECT_NEAR(before - rig.place().z(), 25, 0.5);
  rig.expectDone(id);
}

TEST_F(WhatIsInterrupted, mayBeOnlyWhatWaits) {
  rig.setSpeedOverride(0);
  const GoalId id = rig.submit(inMode(BufferMode::Buffered, lineTo({517.5, -122.3, 361.05, 180, 0, 90})));
  rig.pass(500ms);
  rig.expectInterrupted();
  rig.setSpeedOverride(100);
  rig.pass(2s);
  EXPECT_FALSE(rig.accepted(id));
  rig.expectGoesOn();
  rig.expectDone(id);
}

TEST(WhatIsInterruptedWhileItIsPlanned, isPlannedAnew) {
  InterruptedRobot rig({}, 500ms);
  const GoalId id = rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  rig.pass(100ms);
  rig.expectInterrupted();
  rig.pass(2s);
  EXPECT_FALSE(rig.accepted(id));
  rig.expectGoesOn();
  rig.expectDone(id);
}

}  // namespace
}  // namespace cobot_command::testing
