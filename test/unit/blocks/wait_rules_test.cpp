// What wait_for_input and wait_time take, and the states that they go through.

#include "block_goals.h"
#include "table_checks.h"
#include "waits/queue_wait_states.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

TEST(QueueWaitTable, isSound) {
  expectSoundTable<QueueWaitTable>(QueueWaitState::Ended, QueueWaitEvent::Cancelled, QueueWaitState::Waiting,
                                   {QueueWaitState::Ended});
}

TEST(WaitForInput, takesOnlyInputsThatThereAre) {
  EXPECT_EQ(errorOf(good<WaitForInputGoal>()), 0);
  EXPECT_EQ(errorOf(WaitForInputGoal{"EndModule", 3}), 0);
  EXPECT_EQ(errorOf(WaitForInputGoal{"EndModule", 4}), own_error::kInputInvalid);
  EXPECT_EQ(errorOf(WaitForInputGoal{"ControlBox", -1}), own_error::kInputInvalid);
  EXPECT_EQ(errorOf(WaitForInputGoal{"Safety", 0}), own_error::kInputInvalid);
}

TEST(WaitForInput, takesATimeoutUpToADayOrNone) {
  for (const double timeout : {0.0, 0.001, 86400.0}) {
    EXPECT_EQ(errorWith<WaitForInputGoal>([=](auto& g) { g.timeout = timeout; }), 0) << timeout;
  }
  for (const double timeout : {-0.001, 86400.1, kNan, kInf}) {
    EXPECT_EQ(errorWith<WaitForInputGoal>([=](auto& g) { g.timeout = timeout; }), own_error::kWaitRange)
        << timeout;
  }
}

TEST(WaitTime, takesATimeUpToADay) {
  for (const double time : {0.0, 0.001, 86400.0}) EXPECT_EQ(errorOf(WaitTimeGoal{time}), 0) << time;
  for (const double time : {-0.001, 86400.1, kNan, kInf}) {
    EXPECT_EQ(errorOf(WaitTimeGoal{time}), wait_error::kTime) << time;
  }
  EXPECT_EQ(errorOf(WaitTimeGoal{1, 3}), own_error::kBufferModeUnknown);
}

TEST(WaitTime, isRefusedWithTheNumberOfSrci) {
  EXPECT_EQ(errorOf(WaitTimeGoal{-1}), 0x8D34);
}

TEST(WaitTime, waitsForABlendedMotionInFrontOfItAsAWaitForAnInputDoesNot) {
  EXPECT_TRUE(traitsOf(good<WaitTimeGoal>()).awaits_rest);
  EXPECT_FALSE(traitsOf(good<WaitForInputGoal>()).awaits_rest);
}

}  // namespace
}  // namespace cobot_command::testing
