// What shows that a stop has stopped the robot: frames of the status stream of behind it, and where it stands
// then.

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kNoEffect = "nothing shows that the stop took effect";

MoveAbsoluteGoal toJoints(const std::array<double, 6>& joints_deg) {
  return moveJoints(joints_deg, 10);
}

/// A robot in motion to J1 = 60 degrees, whose stop was accepted.
class StopEvidence : public ::testing::Test {
 protected:
  explicit StopEvidence(const link::LinkSettings& settings = {}) : rig(std::nullopt, settings) {
    rig.connect();
    rig.status(StatusFrames());
  }
  void stopMotion(const Goal& goal = toJoints({60, 0, 90, 0, 90, 0})) {
    move = rig.submit(goal);
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames().moving());
    stop = rig.submit(StopGoal{});
    rig.reply(rig.takeScript().id);
  }
  void expectStopped() {
    ASSERT_NE(rig.outcome(stop), nullptr);
    EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done) << rig.outcome(stop)->error_description;
    ASSERT_NE(rig.outcome(move), nullptr);
  }

  CoreRig rig;
  GoalId move = 0;
  GoalId stop = 0;
};

TEST_F(StopEvidence, isNotTheFrameThatWasOnItsWay) {
  stopMotion();
  rig.pass(2ms);
  rig.status(StatusFrames());  // of before the motion
  EXPECT_EQ(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(move), nullptr);
  rig.pass(15ms);
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.pass(15ms);
  rig.status(StatusFrames());
  expectStopped();
}

TEST_F(StopEvidence, isTheSecondFrameBehindTheAnswer) {
  stopMotion();
  rig.pass(15ms);
  rig.status(StatusFrames());
  rig.pass(15ms);
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.status(StatusFrames());
  expectStopped();
}

/// They have all been on their way for as long as the oldest.
TEST_F(StopEvidence, isNotSeveralFramesThatComeTogether) {
  stopMotion();
  for (int i = 0; i < 40; ++i) {
    rig.status(StatusFrames());
    if (i == 20) rig.pass(1ms);  // what does not go into one piece
  }
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.pass(15ms);
  rig.status(StatusFrames());
  expectStopped();
}

class StopWithASlowStream : public StopEvidence {
 protected:
  StopWithASlowStream() : StopEvidence(slow()) {}
  static link::LinkSettings slow() {
    link::LinkSettings settings;
    settings.status_timeout = 10s;
    return settings;
  }
};

TEST_F(StopWithASlowStream, isConfirmedAtItsDeadlineByTheOneFrameThatCame) {
  stopMotion();
  rig.pass(1500ms);
  rig.status(StatusFrames());
  rig.pass(499ms);
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.pass(1ms);
  expectStopped();
}

TEST_F(StopWithASlowStream, isNotConfirmedByTheOneFrameThatMayHaveBeenOnItsWay) {
  stopMotion();
  rig.pass(2ms);
  rig.status(StatusFrames());
  rig.pass(2s);
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->error_id, own_error::kStopNotConfirmed);
}

/// As of a controller that says OK and drives on.
TEST_F(StopEvidence, ofARobotAtItsTargetIsNoneOfAnEffect) {
  stopMotion();
  rig.stream(StatusFrames().moving(), 20);
  rig.stream(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  expectStopped();
  EXPECT_THAT(rig.outcome(stop)->error_description, HasSubstr(kNoEffect));
  EXPECT_EQ(rig.outcome(move)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr("stop block"));
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr(kNoEffect));
}

TEST_F(StopEvidence, ofARobotOnItsWayIsOne) {
  stopMotion();
  rig.stream(StatusFrames().at({59.8F, 0, 90, 0, 90, 0}));
  expectStopped();
  EXPECT_EQ(rig.outcome(stop)->error_description, "");
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr("the robot was stopped"));
}

TEST_F(StopEvidence, ofABlendedMotionAtItsTargetIsNoneOfAnEffect) {
  MoveAbsoluteGoal blended = toJoints({60, 0, 90, 0, 90, 0});
  blended.blending_enable = true;
  stopMotion(blended);
  rig.stream(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  expectStopped();
  EXPECT_THAT(rig.outcome(stop)->error_description, HasSubstr(kNoEffect));
}

TEST_F(StopEvidence, ofACancelledCycleIsToldInItsResult) {
  PickAndPlaceGoal cycle = good<PickAndPlaceGoal>();
  cycle.steps[0].move = toJoints({60, 0, 90, 0, 90, 0});
  for (const float j1 : {60.0F, 30.0F}) {
    stopMotion(cycle);
    rig.stream(StatusFrames().at({j1, 0, 90, 0, 90, 0}));
    expectStopped();
    EXPECT_THAT(rig.outcome(move)->error_description,
                HasSubstr(j1 == 60.0F ? kNoEffect : "the robot was stopped"));
  }
}

/// Once it stands, a further stop finds nothing that might have ended by itself.
TEST_F(StopEvidence, ofAStopWithoutAMotionSaysNothingOfOne) {
  stopMotion();
  rig.stream(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  const GoalId again = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  ASSERT_NE(rig.outcome(again), nullptr);
  EXPECT_THAT(rig.outcome(again)->error_description, Not(HasSubstr(kNoEffect)));
}

}  // namespace
}  // namespace cobot_command::testing
