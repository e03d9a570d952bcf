#include "runs/command_clock.h"

#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;

constexpr Instant kStart{100s};

/// Sent at kStart; 30 s of patience where nobody can tell whether the robot moves.
class CommandClockTest : public ::testing::Test {
 protected:
  CommandClock clock_{kStart, 30s};
};

TEST_F(CommandClockTest, hasNothingDueBeforeSomethingIsExpected) {
  EXPECT_EQ(clock_.next(), std::nullopt);
  EXPECT_FALSE(clock_.overdue(kStart + 1h));
  EXPECT_FALSE(clock_.beginsNow(kStart + 1h));
  EXPECT_TRUE(clock_.mayExecute(kStart));
  EXPECT_EQ(clock_.executed(kStart + 1h), 0s);
}

TEST_F(CommandClockTest, beginsBehindTheMotionInFront) {
  clock_.expect(kStart, 2s, 10s);
  EXPECT_FALSE(clock_.mayExecute(kStart + 1s));
  EXPECT_EQ(clock_.next(), kStart + 2s);
  EXPECT_FALSE(clock_.beginsNow(kStart + 2s - 1ns));
  EXPECT_TRUE(clock_.beginsNow(kStart + 2s));

  clock_.execute(kStart + 2s);
  EXPECT_FALSE(clock_.beginsNow(kStart + 3s)) << "it has begun";
  EXPECT_EQ(clock_.next(), kStart + 10s);
  EXPECT_EQ(clock_.executed(kStart + 5s), 3s);
}

TEST_F(CommandClockTest, isOverdueAtItsDeadline) {
  clock_.expect(kStart, 0s, 10s);
  clock_.execute(kStart);
  clock_.execute(kStart + 4s);
  EXPECT_EQ(clock_.executed(kStart + 5s), 5s) << "it is executed since the first time";
  EXPECT_FALSE(clock_.overdue(kStart + 10s - 1ns));
  EXPECT_TRUE(clock_.overdue(kStart + 10s));
}

TEST_F(CommandClockTest, standsStillWhileTheRobotIsHeld) {
  clock_.expect(kStart, 0s, 10s);
  clock_.execute(kStart);
  clock_.hold(kStart + 4s);
  clock_.hold(kStart + 5s);
  EXPECT_EQ(clock_.next(), std::nullopt);
  EXPECT_FALSE(clock_.overdue(kStart + 1h));

  clock_.release(kStart + 24s);
  EXPECT_FALSE(clock_.held());
  EXPECT_EQ(clock_.next(), kStart + 30s);
  EXPECT_EQ(clock_.executed(kStart + 24s), 4s);
  EXPECT_TRUE(clock_.patient(kStart + 50s - 1ns));
  EXPECT_FALSE(clock_.patient(kStart + 50s));
  clock_.release(kStart + 40s);
  EXPECT_EQ(clock_.next(), kStart + 30s) << "a second release gives nothing";
}

TEST_F(CommandClockTest, putsOffTheBeginningByAHold) {
  clock_.expect(kStart, 2s, 10s);
  clock_.hold(kStart + 1s);
  EXPECT_FALSE(clock_.beginsNow(kStart + 5s));
  clock_.release(kStart + 5s);
  EXPECT_EQ(clock_.next(), kStart + 6s);
  EXPECT_FALSE(clock_.mayExecute(kStart + 5s));
}

TEST_F(CommandClockTest, countsAHoldFromWhenSomethingIsExpected) {
  clock_.hold(kStart);
  clock_.expect(kStart + 8s, 0s, 10s);
  clock_.release(kStart + 9s);
  EXPECT_EQ(clock_.next(), kStart + 19s);
}

TEST_F(CommandClockTest, keepsADeadlineThatIsAskedForBefore) {
  clock_.expect(kStart, 0s, 10s);
  clock_.execute(kStart);
  clock_.ask(true);
  EXPECT_TRUE(clock_.askedEarly());
  EXPECT_EQ(clock_.next(), std::nullopt) << "the answer has its own time";
  clock_.hold(kStart + 3s);
  clock_.release(kStart + 4s);
  clock_.goOn(kStart + 60s);
  EXPECT_FALSE(clock_.askedEarly());
  EXPECT_EQ(clock_.next(), kStart + 11s);
}

TEST_F(CommandClockTest, takesAnotherDeadlineBehindAQuestionInItsTime) {
  clock_.expect(kStart, 0s, 10s);
  clock_.ask(false);
  EXPECT_FALSE(clock_.askedEarly());
  EXPECT_FALSE(clock_.overdue(kStart + 20s));
  clock_.goOn(kStart + 60s);
  EXPECT_TRUE(clock_.overdue(kStart + 60s));
}

TEST_F(CommandClockTest, awaitsNothingOnceItIsCleared) {
  clock_.expect(kStart, 2s, 10s);
  clock_.hold(kStart + 1s);
  clock_.clear();
  EXPECT_FALSE(clock_.held());
  EXPECT_FALSE(clock_.hasDeadline());
  EXPECT_EQ(clock_.next(), std::nullopt);
  clock_.setDeadline(kStart + 12s);
  EXPECT_EQ(clock_.next(), kStart + 12s);
}

}  // namespace
}  // namespace cobot_command::command
