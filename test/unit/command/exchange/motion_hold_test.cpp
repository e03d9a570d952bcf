// The first motion waits for those that it may blend into: SRCI oracles 7 and 9.
#include "exchange/motion_hold.h"

#include "exchange_rig.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

MoveAbsoluteGoal blended() {
  MoveAbsoluteGoal move = CoreRig::blended(50);
  move.buffer_mode = static_cast<int>(BufferMode::Buffered);
  return move;
}

class MotionHolds : public ::testing::Test {
 protected:
  void enable(int delay, int number) {
    rig.connect();
    exchange = rig.exchangeWith([&](auto& s) {
      s.delay_time = delay;
      s.wait_for_nr_of_cmd = number;
    });
  }
  /// Accepts all that comes; returns how many scripts came.
  int sent() {
    int count = 0;
    while (!rig.nothingSent()) {
      rig.reply(rig.takeScript().id);
      ++count;
    }
    return count;
  }
  ExchangeRig rig;
  GoalId exchange = 0;
};

TEST_F(MotionHolds, lastUntilAsManyMotionsAreThereAsAreWaitedFor) {
  enable(200, 3);
  const GoalId first = rig.submit(blended());
  EXPECT_EQ(rig.progress(first).back().phase, Phase::Queued);
  EXPECT_EQ(rig.progress(first).back().text, "waits for the next motion");
  rig.pass(50ms);
  rig.submit(blended());
  rig.pass(69ms);
  EXPECT_EQ(sent(), 0);
  rig.pass(1ms);
  rig.submit(blended());
  EXPECT_EQ(sent(), 3);
}

TEST_F(MotionHolds, lastNoLongerThanTheDelay) {
  enable(200, 3);
  rig.submit(blended());
  rig.pass(50ms);
  rig.submit(blended());
  rig.pass(149ms);
  EXPECT_EQ(sent(), 0);
  rig.pass(1ms);
  EXPECT_EQ(sent(), 2);
}

TEST_F(MotionHolds, keepThoseThatDoNotBlendAndLetThemGoOneAfterTheOther) {
  enable(200, 3);
  MoveAbsoluteGoal move = blended();
  move.blending_enable = false;
  rig.submit(move);
  rig.submit(move);
  EXPECT_EQ(sent(), 0);
  rig.submit(move);
  EXPECT_EQ(sent(), 1) << "the second one waits for its end";
  rig.tag(1);
  EXPECT_EQ(sent(), 1);
  rig.discardSent();
}

TEST_F(MotionHolds, areNoneForOneMotionWhenOneIsWaitedFor) {
  enable(200, 1);
  rig.submit(blended());
  EXPECT_EQ(sent(), 1);
}

TEST_F(MotionHolds, areNoneWithoutADelay) {
  enable(0, 3);
  rig.submit(blended());
  EXPECT_EQ(sent(), 1);
}

TEST_F(MotionHolds, areNoneBehindAMotionThatIsUnderWay) {
  enable(200, 2);
  MoveAbsoluteGoal move = blended();
  move.blending_enable = false;
  rig.submit(move);
  rig.submit(move);
  EXPECT_EQ(sent(), 1);
  rig.submit(move);
  rig.tag(1);
  EXPECT_EQ(sent(), 1) << "the second one, at once";
  rig.discardSent();
}

TEST_F(MotionHolds, areNoneForWhatMovesNothing) {
  enable(200, 3);
  rig.submit(good<ChangeBaseGoal>());
  EXPECT_EQ(sent(), 1);
}

TEST_F(MotionHolds, refuseAGoalThatDoesNotWait) {
  enable(200, 3);
  rig.submit(blended());
  const GoalId refused = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.errorOf(refused), motion_error::kOtherBlockBusy);
  rig.pass(200ms);
  EXPECT_EQ(sent(), 1);
}

/// SRCI oracle 9.
TEST_F(MotionHolds, endWithAStopAndNoMotionEverLeaves) {
  enable(200, 3);
  const GoalId first = rig.submit(blended());
  const GoalId second = rig.submit(blended());
  rig.submit(StopGoal{});
  EXPECT_THAT(rig.takeScript().script, HasSubstr("StopAndClearBuffer"));
  for (const GoalId id : {first, second}) {
    EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
    EXPECT_FALSE(rig.accepted(id)) << "RECALLED";
  }
  rig.pass(1s);
  rig.discardSent();
}

TEST_F(MotionHolds, endWithTheCancelOfTheFirst) {
  enable(200, 3);
  const GoalId first = rig.submit(blended());
  rig.submit(blended());
  rig.cancel(first);
  EXPECT_EQ(sent(), 1) << "the second one";
}

TEST_F(MotionHolds, endWhenNothingIsEnabledAnyMore) {
  enable(200, 3);
  rig.submit(blended());
  rig.cancel(exchange);
  EXPECT_EQ(sent(), 1);
}

TEST_F(MotionHolds, endWithAGoalThatTakesOver) {
  enable(200, 3);
  const GoalId first = rig.submit(blended());
  MoveAbsoluteGoal urgent = blended();
  urgent.buffer_mode = static_cast<int>(BufferMode::Aborting);
  rig.submit(urgent);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::CommandAborted);
  EXPECT_EQ(sent(), 2) << "the stop that every goal has which takes over, and its motion, at once";
}

TEST(MotionsOf, aPathAreItsPoints) {
  LoadPathGoal path;
  path.path.resize(7);
  EXPECT_EQ(motionsOf(path), 7);
  EXPECT_EQ(motionsOf(CoreRig::move()), 1);
  EXPECT_EQ(motionsOf(good<ChangeBaseGoal>()), 0);
}

}  // namespace
}  // namespace cobot_command::testing
